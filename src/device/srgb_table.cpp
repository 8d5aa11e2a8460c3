#include <teapath/core/color.h>
#include <teapath/device/srgb_table.h>

namespace tp {

const std::array<float, 256>& srgb_table() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> t{};
        for (size_t i = 0; i < t.size(); ++i)
            t[i] = linear_from_srgb(static_cast<float>(i) / 255.0f);
        return t;
    }();
    return table;
}

}  // namespace tp
