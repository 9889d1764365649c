# Debian's libimgui-dev: core, stdlib, FreeType and the GLFW and OpenGL3 back ends in one library, with stb beside it.
find_package(PkgConfig REQUIRED)
pkg_check_modules(IMGUI REQUIRED IMPORTED_TARGET imgui)
pkg_check_modules(STB REQUIRED IMPORTED_TARGET stb)

if(NOT TARGET imgui::imgui)
    add_library(imgui::imgui INTERFACE IMPORTED)
    target_link_libraries(imgui::imgui INTERFACE PkgConfig::IMGUI PkgConfig::STB)
endif()
set(imgui_FOUND TRUE)
