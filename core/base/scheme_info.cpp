#include "core/base/scheme_info.h"

namespace whorl {

std::string thesis_part(std::string_view source) {
    const auto before = source.rfind("; ");
    return std::string(before == std::string_view::npos ? source : source.substr(before + 2));
}

}  // namespace whorl
