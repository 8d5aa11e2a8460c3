# What the window is built from, out of TEAPATH_DEPS (scripts/fetch_window.sh fills it): GLFW, the GL
# loader, Dear ImGui with its backends, ImGuizmo, ImPlot; for the tests also the Dear ImGui test engine,
# which the program does not carry. Their own warnings are theirs.

set(external ${TEAPATH_DEPS}/external)

set(GLFW_BUILD_WAYLAND OFF CACHE BOOL "" FORCE)
set(GLFW_INSTALL OFF CACHE BOOL "" FORCE)
set(GLFW_BUILD_DOCS OFF CACHE BOOL "" FORCE)
set(GLFW_BUILD_EXAMPLES OFF CACHE BOOL "" FORCE)
set(GLFW_BUILD_TESTS OFF CACHE BOOL "" FORCE)
add_subdirectory(${external}/glfw/glfw ${CMAKE_BINARY_DIR}/glfw EXCLUDE_FROM_ALL)

enable_language(C)
add_library(teapath_glad STATIC ${TEAPATH_DEPS}/glad/src/gl.c)
target_include_directories(teapath_glad SYSTEM PUBLIC ${TEAPATH_DEPS}/glad/include)
target_compile_options(teapath_glad PRIVATE -w)

set(imgui ${external}/imgui/imgui)
file(GLOB imgui_sources ${imgui}/*.cpp)
add_library(teapath_imgui STATIC
    ${imgui_sources}
    ${imgui}/backends/imgui_impl_glfw.cpp
    ${imgui}/backends/imgui_impl_opengl3.cpp
    ${imgui}/misc/cpp/imgui_stdlib.cpp
    ${external}/ImGuizmo/ImGuizmo/src/ImGuizmo.cpp
    ${external}/implot/implot/implot.cpp
    ${external}/implot/implot/implot_items.cpp)
target_include_directories(teapath_imgui SYSTEM PUBLIC
    ${imgui} ${imgui}/backends ${imgui}/misc/cpp ${external}/ImGuizmo/ImGuizmo/src ${external}/implot/implot
    ${external}/hello_imgui/hello_imgui/src/hello_imgui ${external}/portable_file_dialogs/portable_file_dialogs)
# Fewer number types: ImPlot's items take a third of the time to compile.
target_compile_definitions(teapath_imgui PUBLIC "IMPLOT_CUSTOM_NUMERIC_TYPES=(float)(double)(int)")
target_compile_options(teapath_imgui PRIVATE -w)
target_link_libraries(teapath_imgui PUBLIC glfw ${CMAKE_DL_LIBS})
if(TEAPATH_SANITIZE MATCHES address)
    # What panels do to ImGui's memory shows in ImGui. Its casts between classes are its own.
    target_compile_options(teapath_imgui PRIVATE -fsanitize=address -fno-omit-frame-pointer)
endif()
if(TEAPATH_TESTS)
    # Hooks of the test engine in the one Dear ImGui, so that the tests run the very objects of the program;
    # src/app/no_test_engine.cpp is what the hooks call there.
    target_compile_definitions(teapath_imgui PUBLIC IMGUI_ENABLE_TEST_ENGINE)
    set(engine ${external}/imgui_test_engine/imgui_test_engine/imgui_test_engine)
    file(GLOB engine_sources ${engine}/*.cpp)
    list(REMOVE_ITEM engine_sources ${engine}/imgui_te_python_gil.cpp)
    add_library(teapath_imgui_test_engine STATIC EXCLUDE_FROM_ALL ${engine_sources})
    target_include_directories(teapath_imgui_test_engine SYSTEM PUBLIC ${engine})
    target_compile_definitions(teapath_imgui_test_engine PUBLIC
        IMGUI_TEST_ENGINE_ENABLE_COROUTINE_STDTHREAD_IMPL=1
        IMGUI_TEST_ENGINE_ENABLE_STD_FUNCTION=1)
    target_compile_options(teapath_imgui_test_engine PRIVATE -w)
    target_link_libraries(teapath_imgui_test_engine PUBLIC teapath_imgui)
endif()
set(fonts ${external}/imgui_rich_md/imgui_rich_md/assets/fonts)
set(TEAPATH_FONTS
    ${fonts}/Roboto/Roboto-Regular.ttf
    ${fonts}/Roboto/Roboto-Bold.ttf
    ${fonts}/Inconsolata-Medium.ttf
    ${external}/hello_imgui/hello_imgui/hello_imgui_assets/fonts/Font_Awesome_6_Free-Solid-900.otf)
