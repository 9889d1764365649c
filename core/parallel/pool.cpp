#include "core/parallel/pool.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#ifdef __SSE2__
#include <immintrin.h>
#endif

namespace whorl {
namespace {

/// Bands a thread: enough to even out rows of unequal cost, few enough to keep rows together in a cache.
constexpr int bands_per_thread = 4;
/// Below this a band is not worth waking a thread for.
constexpr int min_rows_per_band = 4;
/// How long a thread watches for the next loop before it sleeps. Waking takes 20 to 50 µs, longer than most
/// loops over a grid; a solver starts the next one within a few.
constexpr auto patience = std::chrono::microseconds(20);

/// Watches until `ready()` holds or patience ends.
template <class Ready>
void watch(Ready&& ready) {
    const auto end = std::chrono::steady_clock::now() + patience;
    do {
        for (int k = 0; k < 32; ++k) {
            if (ready()) return;
#ifdef __SSE2__
            _mm_pause();
#endif
        }
    } while (std::chrono::steady_clock::now() < end);
}

}  // namespace

void flush_denormals() {
#ifdef __SSE2__
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
#endif
}

struct Pool::Shared {
    std::mutex mutex;
    std::condition_variable wake;
    std::condition_variable done;
    std::vector<std::thread> threads;
    bool stopping = false;
    std::atomic<std::uint64_t> round{0};  ///< counts calls of run; a thread works once a round
    std::atomic<int> working{0};

    Call call = nullptr;
    void* work = nullptr;
    int rows = 0;
    int band = 0;
    std::atomic<int> next{0};

    void take_bands() {
        for (;;) {
            const int first = next.fetch_add(band, std::memory_order_relaxed);
            if (first >= rows) return;
            call(work, first, std::min(first + band, rows));
        }
    }

    void serve() {
        flush_denormals();
        std::uint64_t seen = 0;
        for (;;) {
            watch([&] { return round.load(std::memory_order_acquire) != seen; });
            {
                std::unique_lock lock(mutex);
                wake.wait(lock, [&] { return stopping || round != seen; });
                if (stopping) return;
                seen = round;
            }
            take_bands();
            const std::lock_guard lock(mutex);
            if (--working == 0) done.notify_one();
        }
    }
};

Pool::Pool(int threads) : shared_(std::make_unique<Shared>()) {
    if (threads <= 0) threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    for (int k = 1; k < threads; ++k) shared_->threads.emplace_back([s = shared_.get()] { s->serve(); });
}

Pool::~Pool() {
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->stopping = true;
    }
    shared_->wake.notify_all();
    for (std::thread& thread : shared_->threads) thread.join();
}

int Pool::threads() const {
    return static_cast<int>(shared_->threads.size()) + 1;
}

void Pool::run(int rows, Call call, void* work) {
    if (rows <= 0) return;
    const int helpers = static_cast<int>(shared_->threads.size());
    const int band = std::max(min_rows_per_band, rows / ((helpers + 1) * bands_per_thread));
    if (helpers == 0 || rows <= band) {
        call(work, 0, rows);
        return;
    }
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->call = call;
        shared_->work = work;
        shared_->rows = rows;
        shared_->band = band;
        shared_->next.store(0, std::memory_order_relaxed);
        shared_->working = helpers;
        ++shared_->round;
    }
    shared_->wake.notify_all();
    shared_->take_bands();
    watch([&] { return shared_->working.load(std::memory_order_acquire) == 0; });
    std::unique_lock lock(shared_->mutex);
    shared_->done.wait(lock, [&] { return shared_->working == 0; });
}

}  // namespace whorl
