// Keeps shared libraries loaded, for sanitizer builds only: the OpenGL driver leaves 240 bytes behind when
// EGL unloads it, and a leak in an unloaded library cannot be told from one of ours.
extern "C" int dlclose(void*) {
    return 0;
}
