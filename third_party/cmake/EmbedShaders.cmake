# Turns shader files into a header of string constants: field.frag becomes whorl::app::shaders::field_frag.
# Included, it gives embed_shaders(<header> <file>...); run with -P, it writes the header.
if(NOT CMAKE_SCRIPT_MODE_FILE)
    set(EMBED_SHADERS_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
    function(embed_shaders header)
        add_custom_command(
            OUTPUT ${header}
            COMMAND ${CMAKE_COMMAND} -DHEADER=${header} "-DFILES=${ARGN}" -P ${EMBED_SHADERS_SCRIPT}
            DEPENDS ${ARGN} ${EMBED_SHADERS_SCRIPT}
            COMMENT "Embedding shaders"
            VERBATIM)
    endfunction()
    return()
endif()

set(text "// Written by EmbedShaders.cmake from shaders/; edit those.\n#pragma once\n\n#include <string_view>\n\n")
string(APPEND text "namespace whorl::app::shaders {\n")
foreach(file ${FILES})
    get_filename_component(name ${file} NAME)
    string(MAKE_C_IDENTIFIER ${name} name)
    file(READ ${file} source)
    string(APPEND text "inline constexpr std::string_view ${name} = R\"glsl(${source})glsl\";\n")
endforeach()
string(APPEND text "}  // namespace whorl::app::shaders\n")
file(WRITE ${HEADER} "${text}")
