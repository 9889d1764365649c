#include "core/base/archive.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace whorl {

void SavingArchive::pass(std::string_view, std::span<std::byte> numbers) {
    saved.insert(saved.end(), numbers.begin(), numbers.end());
}

void RestoringArchive::pass(std::string_view name, std::span<std::byte> numbers) {
    if (saved_.size() < numbers.size()) throw std::logic_error(std::string(name) + " was not saved");
    std::copy_n(saved_.begin(), numbers.size(), numbers.begin());
    saved_ = saved_.subspan(numbers.size());
}

void DigestingArchive::pass(std::string_view, std::span<std::byte> numbers) {
    constexpr std::uint64_t prime = 0x100000001b3;
    while (!numbers.empty()) {
        std::uint64_t word = 0;
        const std::size_t size = std::min(sizeof word, numbers.size());
        std::memcpy(&word, numbers.data(), size);
        value_ = (value_ ^ word) * prime;
        numbers = numbers.subspan(size);
    }
}

}  // namespace whorl
