// `whorl explain`: how a step made one value.
#include <cstdio>

#include "app/cli/headless.h"
#include "app/cli/progress.h"
#include "app/cli/verbs.h"
#include "core/base/error.h"
#include "core/base/suggest.h"
#include "core/inspect/explain.h"
#include "core/inspect/limiter_map.h"
#include "core/inspect/text.h"

namespace whorl::app {

int run_explain(const ExplainArguments& arguments) {
    const FieldId quantity = find_advected(arguments.field);
    if (arguments.cell.size() != 2) throw InputError("--cell takes two numbers, as 20,12");
    Pool pool(arguments.threads);
    Session session(recording_for(arguments.scene, arguments.lanes, arguments.set), pool);
    {
        Progress progress(arguments.scene, arguments.at);
        while (session.step_number() < arguments.at && session.running()) {
            session.step();
            progress.at(session.step_number());
        }
    }
    const std::vector<std::string> names = titles(session.setup());
    for (std::size_t k = 0; k < session.lane_count(); ++k) {
        const Lane& lane = session.lane(k);
        if (lane.failure()) throw NotFinite(names[k] + ": " + *lane.failure());
        const auto last = lane.simulation().last_advection();
        if (!last)
            throw InputError("the fields or walls were changed right after step " +
                             std::to_string(arguments.at) + "; ask for another one");
        if (session.lane_count() > 1) std::printf("%s%s\n", k == 0 ? "" : "\n", names[k].c_str());
        std::fputs(write_text(explain(*last, quantity, arguments.cell[0], arguments.cell[1], pool)).c_str(),
                   stdout);
        Field marks;
        const int limited = limiter_map(*last, quantity, pool, marks);
        std::printf("limiters acted at %d of %d nodes\n", limited, marks.width() * marks.height());
    }
    return 0;
}

}  // namespace whorl::app
