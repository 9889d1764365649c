// How a plain loop is compiled for the vector units at hand.
#pragma once

/// Compiles a function for SSE2, AVX2 and AVX-512 and picks at load time. Results are the same bits on each:
/// products are never contracted to fused multiply-adds, and sums run over a fixed number of lanes.
/// Sanitizers instrument the pick before they are ready for it, so their builds take the baseline.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define WHORL_VECTOR_CLONES __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#else
#define WHORL_VECTOR_CLONES
#endif
