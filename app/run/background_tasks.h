// Work on files that no frame waits for: one piece after the other, on a thread of its own.
#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <future>
#include <string>
#include <utility>

#include "app/ui/event_log.h"
#include "app/ui/notifications.h"

namespace whorl::app {

/// A piece of work, and what is said of it.
struct BackgroundTask {
    std::string event;                  ///< name in the event log; with "-failed" behind it if it fails
    std::string done, failed;           ///< notifications, before the result and the reason
    std::function<std::string()> work;  ///< @return what came of it, @throws std::exception with a reason
};

class BackgroundTasks {
  public:
    void add(BackgroundTask task) { waiting_.push_back(std::move(task)); }
    bool busy() const { return doing_.valid() || !waiting_.empty(); }

    /// Says what became of the last piece and begins the next; call once a frame.
    void end_frame(Notifications& notifications, EventLog& log) {
        if (doing_.valid() && doing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
            try {
                const std::string result = doing_.get();
                if (!task_.done.empty()) notifications.info(task_.done + result);
                log.event(task_.event, result);
            } catch (const std::exception& e) {
                notifications.warn(task_.failed + e.what());
                log.event(task_.event + "-failed", e.what());
            }
        }
        if (doing_.valid() || waiting_.empty()) return;
        task_ = std::move(waiting_.front());
        waiting_.pop_front();
        doing_ = std::async(std::launch::async, std::move(task_.work));
    }

  private:
    std::deque<BackgroundTask> waiting_;
    BackgroundTask task_;
    std::future<std::string> doing_;
};

}  // namespace whorl::app
