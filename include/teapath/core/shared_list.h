// A list whose copies share their elements until one of them is changed, so that a copy costs
// nothing and copies of the same list are equal at once. Reading is as with std::vector; what is to
// be changed is asked for by `edit`. A copy may be read by another thread while this one changes.
#pragma once

#include <atomic>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace tp {

template <class T>
class SharedList {
public:
    using value_type = T;

    SharedList() = default;
    SharedList(std::vector<T> items) : items_(std::make_shared<std::vector<T>>(std::move(items))) {}
    SharedList(std::initializer_list<T> items) : SharedList(std::vector<T>(items)) {}

    const std::vector<T>& items() const {
        static const std::vector<T> none;
        return items_ ? *items_ : none;
    }
    operator const std::vector<T>&() const { return items(); }
    auto begin() const { return items().begin(); }
    auto end() const { return items().end(); }
    size_t size() const { return items().size(); }
    bool empty() const { return items().empty(); }
    const T& operator[](size_t i) const { return items()[i]; }
    const T& front() const { return items().front(); }
    const T& back() const { return items().back(); }

    /// The elements, to be changed at once; they are this list's alone. Elements that were looked
    /// at before may be those of other copies from now on.
    std::vector<T>& edit() {
        if (items_.use_count() != 1) items_ = std::make_shared<std::vector<T>>(items());
        std::atomic_thread_fence(std::memory_order_acquire);  // after who let go of it last
        return *items_;
    }

    friend bool operator==(const SharedList& a, const SharedList& b) {
        return a.items_ == b.items_ || a.items() == b.items();
    }

private:
    std::shared_ptr<std::vector<T>> items_;  // null: empty
};

/// The elements for code that is written once for both: to be changed where the list may be.
template <class T>
const std::vector<T>& elements(const SharedList<T>& list) {
    return list.items();
}
template <class T>
std::vector<T>& elements(SharedList<T>& list) {
    return list.edit();
}

}  // namespace tp
