// See columns.h.
#include "app/cli/columns.h"

#include <algorithm>

namespace whorl::app {

Columns::Columns(bool Tables::*table, const std::string& picked, Needs also) {
    for (std::size_t from = 0; !picked.empty() && from <= picked.size();) {
        const std::size_t comma = std::min(picked.find(',', from), picked.size());
        add(measures().find(picked.substr(from, comma - from)));
        from = comma + 1;
    }
    for (const Measure* measure : measures().all()) {
        const bool wanted = also != Needs::Nothing && measure->needs == also;
        if (wanted || (picked.empty() && measure->tables.*table)) add(*measure);
    }
}

void Columns::add(const Measure& measure) {
    if (std::find(measures_.begin(), measures_.end(), &measure) == measures_.end())
        measures_.push_back(&measure);
}

void Columns::errors_first() {
    std::stable_partition(measures_.begin(), measures_.end(),
                          [](const Measure* measure) { return measure->needs == Needs::Reference; });
}

std::string Columns::header() const {
    std::string line = "step,time";
    for (const Measure* measure : measures_) line += "," + measure->key;
    return line;
}

const std::vector<double>& Columns::row(long step, const Measures& measured) {
    row_ = {static_cast<double>(step), measured.time};
    for (const Measure* measure : measures_) row_.push_back(measure->of(measured));
    return row_;
}

}  // namespace whorl::app
