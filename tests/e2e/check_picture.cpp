// Reads a picture back: prints its size, a sum over its pixels and its texts, fails if it shows nothing.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>

#include "core/io/png.h"

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    try {
        std::vector<whorl::TextChunk> texts;
        const whorl::Image image = whorl::read_png(argv[1], &texts);
        std::printf("%d x %d\n", image.width, image.height);
        std::uint64_t sum = 14695981039346656037u;  // FNV-1a
        for (const std::uint8_t byte : image.rgba) sum = (sum ^ byte) * 1099511628211u;
        std::printf("%016llx\n", static_cast<unsigned long long>(sum));
        for (const auto& [key, text] : texts) std::printf("%s:\n%s\n", key.c_str(), text.c_str());
        const auto [least, most] = std::minmax_element(image.rgba.begin(), image.rgba.end());
        return *most > *least + 100 ? 0 : 1;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s\n", e.what());
        return 1;
    }
}
