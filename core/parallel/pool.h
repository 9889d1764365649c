// A small pool of threads that works through bands of rows.
#pragma once

#include <functional>
#include <memory>

namespace whorl {

/// `threads` threads, the caller's among them, that split loops over rows into bands.
/// Which thread computes a row never changes its result, so results do not depend on the thread count.
class Pool {
  public:
    /// @param threads 1 or more; 0 takes one a core.
    explicit Pool(int threads = 1);
    ~Pool();
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;

    int threads() const;

    /// Calls `work(first, last)`, or `work(first, last, thread)` with thread in [0, threads()), on bands that
    /// cover [0, rows), and returns when all are done.
    /// `work` must not throw, and must not call the pool.
    template <class Work>
    void bands(int rows, Work&& work) {
        run(
            rows,
            [](void* w, int first, int last, int thread) {
                auto& on_band = *static_cast<std::remove_reference_t<Work>*>(w);
                if constexpr (std::is_invocable_v<Work&, int, int, int>) {
                    on_band(first, last, thread);
                } else {
                    on_band(first, last);
                }
            },
            &work);
    }

  private:
    using Call = void (*)(void*, int first, int last, int thread);
    void run(int rows, Call call, void* work);

    struct Shared;
    std::unique_ptr<Shared> shared_;
};

/// Makes this thread treat denormal numbers as 0: a dissipated tail is not worth a hundred times the work.
void flush_denormals();

}  // namespace whorl
