// A view of an array that host and device can both hold: pointer and count, no ownership.
#pragma once

#include <teapath/core/host_device.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace tp {

template <class T>
struct Span {
    T* data = nullptr;
    uint32_t size = 0;

    TP_HD_MEMBER T& operator[](uint32_t i) const {
        TP_ASSERT(i < size);
        return data[i];
    }
    TP_HD_MEMBER T* begin() const { return data; }
    TP_HD_MEMBER T* end() const { return data + size; }
    TP_HD_MEMBER bool empty() const { return size == 0; }
    template <class U>
    requires(std::is_same_v<U, const T> && !std::is_const_v<T>) TP_HD_MEMBER operator Span<U>()
        const {
        return {data, size};
    }
};

/// A view of a std::vector or anything like it; it must outlive the view.
template <class Container>
auto make_span(Container& c) {
    using T = std::remove_pointer_t<decltype(c.data())>;
    return Span<T>{c.data(), static_cast<uint32_t>(c.size())};
}

}  // namespace tp
