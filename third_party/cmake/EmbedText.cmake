# Turns text files into a header of string constants: shaders/field.frag becomes shaders::field_frag.
# Included, it gives embed_text(<header> <namespace> <file>...); run with -P, it writes the header.
if(NOT CMAKE_SCRIPT_MODE_FILE)
    set(EMBED_TEXT_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
    function(embed_text header namespace)
        add_custom_command(
            OUTPUT ${header}
            COMMAND ${CMAKE_COMMAND} -DHEADER=${header} -DNAMESPACE=${namespace} "-DFILES=${ARGN}" -P
                    ${EMBED_TEXT_SCRIPT}
            DEPENDS ${ARGN} ${EMBED_TEXT_SCRIPT}
            COMMENT "Embedding ${namespace}"
            VERBATIM)
    endfunction()
    return()
endif()

set(text "// Written by EmbedText.cmake; edit the files it was made from.\n#pragma once\n\n#include <string_view>\n\n")
string(APPEND text "namespace whorl::app::${NAMESPACE} {\n")
foreach(file ${FILES})
    get_filename_component(name ${file} NAME)
    string(MAKE_C_IDENTIFIER ${name} name)
    file(READ ${file} source)
    string(APPEND text "inline constexpr std::string_view ${name} = R\"whorl(${source})whorl\";\n")
endforeach()
string(APPEND text "}  // namespace whorl::app::${NAMESPACE}\n")
file(WRITE ${HEADER} "${text}")
