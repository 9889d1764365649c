#include "core/advection/transport.h"

namespace whorl {

void archive_field(Archive& archive, std::string_view name, Field& field) {
    int width = field.width(), height = field.height();
    auto site = static_cast<int>(field.site());
    archive(name, width);
    archive(name, height);
    archive(name, site);
    if (width != field.width() || height != field.height() || site != static_cast<int>(field.site()))
        field = Field(width, height, static_cast<Site>(site));
    const std::size_t rows = static_cast<std::size_t>(height) + 2 * Field::ghost;
    archive(name, std::span<Real>(field.row(-Field::ghost) - Field::ghost,
                                  rows * static_cast<std::size_t>(field.stride())));
}

}  // namespace whorl
