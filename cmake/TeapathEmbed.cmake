# teapath_embed(TARGET FILE …)
# Puts files into the program itself: src/app/embedded.h gives them back by their names, without folders.
function(teapath_embed target)
    set(index 0)
    foreach(file ${ARGN})
        get_filename_component(name ${file} NAME)
        set(symbol teapath_embedded_${index})
        string(APPEND assembly
            "    \".globl ${symbol}\\n.hidden ${symbol}\\n.balign 16\\n${symbol}:\\n.incbin \\\"${file}\\\"\\n\"\n"
            "    \".globl ${symbol}_end\\n.hidden ${symbol}_end\\n${symbol}_end:\\n\"\n")
        string(APPEND declarations "extern const char ${symbol}[], ${symbol}_end[];\n")
        string(APPEND rows "        {\"${name}\", ${symbol}, ${symbol}_end},\n")
        math(EXPR index "${index} + 1")
    endforeach()
    set(source ${CMAKE_CURRENT_BINARY_DIR}/embedded.cpp)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/embedded.cpp.in ${source} @ONLY)
    set_source_files_properties(${source} PROPERTIES OBJECT_DEPENDS "${ARGN}")
    target_sources(${target} PRIVATE ${source})
endfunction()
