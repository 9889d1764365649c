// What is thrown at bad input: one line that names what was wrong and what would be right.
#pragma once

#include <stdexcept>

namespace whorl {

struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace whorl
