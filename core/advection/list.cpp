// The list of advectors, in the order of menus.
#include "core/advection/advector.h"

namespace whorl {

extern const Advector semi_lagrangian, maccormack, bfecc, aslam, aslam_zero, aslam_bilinear;

Registry<Advector>& Advector::list() {
    static Registry<Advector> list("advector", {&semi_lagrangian,  //
                                                &maccormack,       //
                                                &bfecc,            //
                                                &aslam,            //
                                                &aslam_zero,       //
                                                &aslam_bilinear});
    return list;
}

}  // namespace whorl
