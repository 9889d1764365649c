// Every phase, a line each.
#include "core/scene/phase.h"

namespace whorl {

extern const Phase prescribe_phase, forces_phase, projection_phase, advection_phase;

Registry<Phase>& phases() {
    static Registry<Phase> all("phase", {
                                            &prescribe_phase,   //
                                            &forces_phase,      //
                                            &projection_phase,  //
                                            &advection_phase,   //
                                        });
    return all;
}

}  // namespace whorl
