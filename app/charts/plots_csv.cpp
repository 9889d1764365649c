#include "app/charts/plots_csv.h"

#include "core/base/csv.h"

namespace whorl::app {
namespace {

/// Curves are kept in single precision.
std::string number(float value) {
    return csv_number(static_cast<double>(value), 7);
}

}  // namespace

std::string plots_csv(const std::vector<CsvLane>& lanes) {
    std::string out = "step,time,lane,title";
    for (const Measure* measure : measures().all()) out += "," + measure->key;
    out += '\n';
    for (std::size_t k = 0; k < lanes.size(); ++k) {
        const LaneHistory& lane = lanes[k].history;
        const std::string name = "," + std::to_string(k + 1) + "," + csv_text(lanes[k].title);
        for (std::size_t row = 0; row < lane.steps.size(); ++row) {
            out += std::to_string(static_cast<long>(lane.steps[row])) + ",";
            out += number(lane.times[row]);
            out += name;
            for (const std::vector<float>& curve : lane.curves) out += ',' + number(curve[row]);
            out += '\n';
        }
    }
    return out;
}

}  // namespace whorl::app
