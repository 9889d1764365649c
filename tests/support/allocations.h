// Counts what the whole program allocates: a test that asks is a program of its own.
#pragma once

namespace whorl::test {

/// Calls of operator new since the program began.
long allocations();

}  // namespace whorl::test
