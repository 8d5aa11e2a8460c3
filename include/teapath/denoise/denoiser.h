// Denoising by Intel's Open Image Denoise, a library that is loaded where it is: without it there
// is a sentence that says so, and noise.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tp {

/// Where the library is looked for first: a folder, or the file itself. Then beside the program, in
/// ../lib from there, where the set-up puts it, and where the system has libraries.
inline constexpr const char* kDenoiserVariable = "TEAPATH_OIDN";

/// Planes of a picture, row-major, three numbers a pixel. Albedo and normal may be empty.
struct NoisyImage {
    int width = 0;
    int height = 0;
    std::span<const float> radiance;  // linear, 0 or more
    std::span<const float> albedo;    // 0 to 1
    std::span<const float> normal;    // -1 to 1
};

/// Live: as fast as it goes. Final: the noise of albedo and normal is taken away first.
enum class DenoiseQuality { Live, Final };

class Denoiser {
public:
    /// Takes a CUDA device where `on_gpu` and there is one, else the processor. Throws
    /// Error(Device) where the library is missing or does not start.
    explicit Denoiser(bool on_gpu);
    ~Denoiser();
    Denoiser(Denoiser&&) noexcept;
    Denoiser& operator=(Denoiser&&) noexcept;

    /// The radiance without its noise. What is not finite counts as black. Throws Error(Device),
    /// for one where memory is short.
    std::vector<float> run(const NoisyImage& image, DenoiseQuality quality);

    /// For people: "Open Image Denoise 2.5.1 on the processor".
    std::string name() const;

    /// Why no denoiser can be made, with the remedy; empty where one can.
    static std::string why_missing();

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace tp
