#include "makers.h"
#include "surfaces.h"

#include <glm/gtc/constants.hpp>

namespace tp {
namespace {

using Points = std::vector<Double3>;

// A teapot about 2 units wide that stands on y = 0: body and lid revolved, spout and handle tubes.
const Points kBody = {{0, 0.02, 0},    {0.2, 0.02, 0},  {0.42, 0.0, 0},  {0.46, 0.05, 0},
                      {0.7, 0.16, 0},  {0.82, 0.36, 0}, {0.8, 0.56, 0},  {0.78, 0.76, 0},
                      {0.62, 0.92, 0}, {0.47, 0.97, 0}, {0.44, 0.98, 0}, {0.43, 1.0, 0},
                      {0.44, 1.01, 0}};
const Points kLid = {{0.45, 1.0, 0},   {0.44, 1.03, 0},   {0.38, 1.08, 0},  {0.25, 1.12, 0},
                     {0.16, 1.145, 0}, {0.08, 1.14, 0},   {0.06, 1.17, 0},  {0.05, 1.19, 0},
                     {0.1, 1.2, 0},    {0.115, 1.245, 0}, {0.125, 1.29, 0}, {0.07, 1.315, 0},
                     {0, 1.315, 0}};
const Points kSpout = {{0.66, 0.42, 0}, {1.0, 0.42, 0}, {0.98, 0.78, 0}, {1.2, 0.97, 0}};
const Points kHandle = {{-0.69, 0.78, 0}, {-0.95, 0.92, 0}, {-1.2, 0.85, 0}, {-1.14, 0.58, 0},
                        {-1.09, 0.36, 0}, {-0.9, 0.28, 0},  {-0.7, 0.3, 0}};

// Of a bottle with its wall and bottom, outside from below, inside from above.
const Points kBottle = {
    {0, 0.0, 0},      {0.2, 0.0, 0},   {0.3, 0.0, 0},   {0.33, 0.02, 0},  {0.37, 0.04, 0},
    {0.37, 0.06, 0},  {0.37, 0.12, 0}, {0.37, 0.4, 0},  {0.37, 0.7, 0},   {0.37, 0.86, 0},
    {0.37, 1.02, 0},  {0.13, 1.0, 0},  {0.12, 1.16, 0}, {0.115, 1.25, 0}, {0.115, 1.3, 0},
    {0.115, 1.36, 0}, {0.115, 1.4, 0}, {0.09, 1.4, 0},  {0.085, 1.36, 0}, {0.085, 1.3, 0},
    {0.085, 1.25, 0}, {0.09, 1.14, 0}, {0.1, 0.98, 0},  {0.33, 0.98, 0},  {0.33, 0.84, 0},
    {0.33, 0.7, 0},   {0.33, 0.4, 0},  {0.33, 0.14, 0}, {0.33, 0.09, 0},  {0.3, 0.08, 0},
    {0.28, 0.08, 0},  {0.2, 0.08, 0},  {0.1, 0.09, 0},  {0, 0.09, 0}};

const Points kWineGlass = {
    {0, 0, 0},       {0.15, 0, 0},      {0.36, 0, 0},      {0.38, 0.01, 0}, {0.39, 0.03, 0},
    {0.1, 0.02, 0},  {0.05, 0.09, 0},   {0.035, 0.2, 0},   {0.035, 0.5, 0}, {0.04, 0.72, 0},
    {0.06, 0.8, 0},  {0.42, 0.86, 0},   {0.46, 1.15, 0},   {0.47, 1.4, 0},  {0.36, 1.65, 0},
    {0.35, 1.8, 0},  {0.348, 1.815, 0}, {0.335, 1.815, 0}, {0.334, 1.8, 0}, {0.344, 1.65, 0},
    {0.454, 1.4, 0}, {0.444, 1.15, 0},  {0.41, 0.92, 0},   {0.1, 0.83, 0},  {0, 0.83, 0}};
const Points kWine = {{0, 0.834, 0},   {0.1, 0.834, 0},  {0.408, 0.922, 0}, {0.442, 1.15, 0},
                      {0.445, 1.2, 0}, {0.445, 1.22, 0}, {0.444, 1.235, 0}, {0.3, 1.23, 0},
                      {0.15, 1.23, 0}, {0, 1.23, 0}};

const Points kBowl = {{0, 0, 0},        {0.15, 0, 0},    {0.25, 0, 0},      {0.28, 0, 0},
                      {0.3, 0.0, 0},    {0.28, 0.06, 0}, {0.32, 0.07, 0},   {0.55, 0.12, 0},
                      {0.72, 0.3, 0},   {0.78, 0.52, 0}, {0.785, 0.545, 0}, {0.765, 0.55, 0},
                      {0.755, 0.53, 0}, {0.69, 0.32, 0}, {0.52, 0.16, 0},   {0.3, 0.11, 0},
                      {0.2, 0.09, 0},   {0.1, 0.09, 0},  {0, 0.09, 0}};

int detail_of(ProceduralParameters& p, int standard) {
    return p.whole("detail", standard, 3, 1024);
}

Mesh revolved(const Points& profile, int detail) {
    Mesh mesh;
    add_revolution(mesh, 2 * detail, static_cast<int>(profile.size() - 1) / 3 * detail / 4 + detail,
                   profile);
    return mesh;
}

}  // namespace

Mesh make_teapot(ProceduralParameters& p) {
    const int detail = detail_of(p, 24);
    Mesh mesh;
    add_revolution(mesh, 3 * detail, 3 * detail, kBody);
    add_revolution(mesh, 3 * detail, 3 * detail, kLid);
    add_tube(
        mesh, 2 * detail, 2 * detail, [](double t) { return bezier(kSpout, t); },
        [](double t) { return 0.19 - 0.12 * t + 0.02 * t * t; }, false);
    add_tube(
        mesh, detail, 3 * detail, [](double t) { return bezier(kHandle, t); },
        [](double t) { return 0.06 + 0.02 * std::cos(glm::two_pi<double>() * t); }, false);
    return mesh;
}

Mesh make_bottle(ProceduralParameters& p) {
    return revolved(kBottle, detail_of(p, 48));
}

Mesh make_wine_glass(ProceduralParameters& p) {
    // The wine alone where it is asked for: it has a material of its own.
    const bool filled = p.whole("filled", 0, 0, 1) == 1;
    return revolved(filled ? kWine : kWineGlass, detail_of(p, 48));
}

Mesh make_bowl(ProceduralParameters& p) {
    return revolved(kBowl, detail_of(p, 48));
}

}  // namespace tp
