// The list of explanations, by advector.
#include "core/inspect/explainer.h"

namespace whorl {

extern const AdvectorExplanation of_semi_lagrangian, of_maccormack, of_bfecc, of_aslam, of_aslam_zero,
    of_aslam_bilinear;

Registry<AdvectorExplanation>& AdvectorExplanation::list() {
    static Registry<AdvectorExplanation> list("explanation", {&of_semi_lagrangian,  //
                                                              &of_maccormack,       //
                                                              &of_bfecc,            //
                                                              &of_aslam,            //
                                                              &of_aslam_zero,       //
                                                              &of_aslam_bilinear});
    return list;
}

}  // namespace whorl
