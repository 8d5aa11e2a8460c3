// Names and labels of the backends, for the command line and menus.
#pragma once

#include <teapath/core/enum_table.h>
#include <teapath/render/backend.h>

namespace tp {

template <>
struct EnumTable<BackendKind> {
    using E = BackendKind;
    static constexpr std::array rows = {EnumRow<E>{E::Auto, "auto", "Automatic"},
                                        EnumRow<E>{E::Cuda, "cuda", "CUDA"},
                                        EnumRow<E>{E::Host, "host", "Host"}};
};

}  // namespace tp
