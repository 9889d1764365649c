// The list of tracers, in the order of menus.
#include "core/tracing/tracer.h"

namespace whorl {

extern const Tracer rk3;

Registry<Tracer>& Tracer::list() {
    static Registry<Tracer> list("tracer", {&midpoint,  //
                                            &euler,     //
                                            &rk3,       //
                                            &rk4});
    return list;
}

}  // namespace whorl
