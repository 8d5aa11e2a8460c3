# Compile options that every target of ours shares, and the function that makes one module's library.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
endif()

if(TEAPATH_CUDA)
    enable_language(CUDA)
    find_package(CUDAToolkit REQUIRED)
    set(CMAKE_CUDA_STANDARD 20)
    if(NOT CMAKE_CUDA20_STANDARD_COMPILE_OPTION)
        # CMake 3.25.1 does not know that nvcc 12 and later compile C++20.
        set(CMAKE_CUDA20_STANDARD_COMPILE_OPTION "-std=c++20")
        set(CMAKE_CUDA20_EXTENSION_COMPILE_OPTION "-std=c++20")
    endif()
endif()

# Warnings of our own code. Numbers of the path tracer stay IEEE: no -ffast-math on the host, so that
# a NaN can be seen; errno and trapping are not used. One rounding for every compiler: no contraction.
add_library(teapath_options INTERFACE)
target_include_directories(teapath_options INTERFACE ${PROJECT_SOURCE_DIR}/include)
target_compile_options(teapath_options INTERFACE
    $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast
                              -Wcast-align -Woverloaded-virtual -fno-math-errno -fno-trapping-math
                              -ffp-contract=off>
    # On the device: flush denormals, approximate division and root (2 ulp), no warnings about GLM's
    # defaulted functions.
    $<$<COMPILE_LANGUAGE:CUDA>:--ftz=true --prec-div=false --prec-sqrt=false --expt-relaxed-constexpr
                               -diag-suppress=20012 -Xcompiler=-Wall,-Wextra,-Wshadow>)
if(TEAPATH_WERROR)
    target_compile_options(teapath_options INTERFACE
        $<$<COMPILE_LANGUAGE:CXX>:-Werror>
        $<$<COMPILE_LANGUAGE:CUDA>:-Werror=all-warnings -Xcompiler=-Werror>)
endif()
if(TEAPATH_SANITIZE)
    target_compile_options(teapath_options INTERFACE
        $<$<COMPILE_LANGUAGE:CXX>:-fsanitize=${TEAPATH_SANITIZE} -fno-omit-frame-pointer
                                  -fno-sanitize-recover=undefined>)
    target_link_options(teapath_options INTERFACE -fsanitize=${TEAPATH_SANITIZE})
    # g++ 12 takes the sanitizers' own checks inside std::regex for reads of unset memory.
    target_compile_options(teapath_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:$<$<COMPILE_LANGUAGE:CXX>:-Wno-maybe-uninitialized>>)
endif()

# teapath_module(NAME SOURCES … [USES module …] [LIBRARIES target …])
# The library teapath_NAME from src/NAME; USES are the modules that it may see, as design has it.
function(teapath_module name)
    cmake_parse_arguments(arg "" "" "SOURCES;USES;LIBRARIES" ${ARGN})
    set(library teapath_${name})
    add_library(${library} STATIC ${arg_SOURCES})
    add_library(teapath::${name} ALIAS ${library})
    list(TRANSFORM arg_USES PREPEND teapath_)
    target_link_libraries(${library} PUBLIC teapath_options ${arg_USES} PRIVATE ${arg_LIBRARIES})
endfunction()
