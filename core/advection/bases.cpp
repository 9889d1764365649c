// The list of base schemes, in the order of menus.
#include "core/advection/advector.h"

namespace whorl {

extern const Advector semi_lagrangian, aslam, aslam_bilinear;

namespace {

constexpr BaseScheme semi_lagrangian_base{
    .info{"semi-lagrangian", "Semi-Lagrangian", "Stam 1999; thesis alg. 3.1",
          "Trace each node back along the flow and interpolate there."},
    .step = &semi_lagrangian,
    .clamped = false};
constexpr BaseScheme aslam_base{
    .info{"aslam", "ASLAM", "thesis alg. 4.1, eq. 4.1–4.3",
          "Trace a stencil of particles a node; each carries its value and gradient."},
    .step = &aslam,
    .clamped = false};
/// ASLAM as a base step that keeps its clamp: the thesis' MC-ASLAM-CLAMPED.  [T sec. 5.5]
constexpr BaseScheme aslam_clamped_base{
    .info{"aslam-clamped", "ASLAM, clamped", "thesis sec. 5.5",
          "ASLAM with its clamp kept inside the predictor and the corrector."},
    .step = &aslam,
    .clamped = true};
constexpr BaseScheme aslam_bilinear_base{
    .info{"aslam-bilinear", "ASLAM-bilinear", "after thesis sec. 6.1",
          "ASLAM with the bilinear cross term, which keeps a field at rest as it is."},
    .step = &aslam_bilinear,
    .clamped = false};

}  // namespace

Registry<BaseScheme>& BaseScheme::list() {
    static Registry<BaseScheme> list("base step", {&semi_lagrangian_base,  //
                                                   &aslam_base,            //
                                                   &aslam_clamped_base,    //
                                                   &aslam_bilinear_base});
    return list;
}

}  // namespace whorl
