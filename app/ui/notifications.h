// Lines that tell a person what has happened, for some seconds.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace whorl::app {

/// One line over the field.
struct Notification {
    enum class Kind { Info, Warning };

    std::string text;
    Kind kind = Kind::Info;
    double until = 0;  ///< when it goes, seconds of the window's clock
};

/// The notifications on screen, oldest first; a new one pushes the oldest out.
class Notifications {
  public:
    void set_time(double now) {
        now_ = now;
        std::erase_if(shown_, [&](const Notification& notification) { return notification.until < now; });
    }
    void info(std::string text) { add(std::move(text), Notification::Kind::Info, 6.0); }
    void warn(std::string text) { add(std::move(text), Notification::Kind::Warning, 10.0); }
    const std::vector<Notification>& shown() const { return shown_; }
    double time() const { return now_; }

  private:
    static constexpr std::size_t most = 3;

    void add(std::string text, Notification::Kind kind, double seconds) {
        std::erase_if(shown_, [&](const Notification& notification) { return notification.text == text; });
        shown_.push_back({std::move(text), kind, now_ + seconds});
        if (shown_.size() > most) shown_.erase(shown_.begin());
    }

    double now_ = 0;
    std::vector<Notification> shown_;
};

}  // namespace whorl::app
