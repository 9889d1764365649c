#include <algorithm>

#include "tests/fuzz/fuzz.h"

namespace whorl::fuzz {

std::uint64_t Random::operator()() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

void mutate_bytes(std::string& input, Random& random, std::span<const std::string> others,
                  std::span<const std::string> dictionary) {
    const std::size_t at = random.below(input.size() + 1);
    const std::size_t length = random.below(std::min<std::size_t>(input.size() - at, 200) + 1);
    switch (random.below(11)) {
        case 0:
            if (at < input.size()) input[at] = static_cast<char>(input[at] ^ 1 << random.below(8));
            break;
        case 1:
            if (at < input.size()) input[at] = static_cast<char>(random());
            break;
        case 2:
            input.resize(at);
            break;
        case 3:
            input.erase(at, length);
            break;
        case 4:
            input.insert(random.below(input.size() + 1), input.substr(at, length));
            break;
        case 5: {
            const std::string& other = random.of(others);
            input.insert(at, other.substr(random.below(other.size() + 1), random.below(400)));
            break;
        }
        case 6:
            input = input.substr(0, at) + random.of(others);
            break;
        case 7: {
            std::string number = random.one_in(2) ? "-" : "";
            for (std::size_t digits = 1 + random.below(25); digits > 0; --digits)
                number += static_cast<char>('0' + random.below(10));
            input.insert(at, number);
            break;
        }
        case 8:
        case 9:
            input.insert(at, random.of(dictionary));
            break;
        default: {
            constexpr std::size_t times[] = {2, 10, 300, 3000, 100'000};
            const std::string word = random.of(dictionary);
            std::string many;
            for (std::size_t k = random.of(times); k > 0 && many.size() < max_input; --k) many += word;
            input.insert(at, many);
        }
    }
    if (input.size() > max_input) input.resize(max_input);
}

}  // namespace whorl::fuzz
