// The list of stencils, in the order of menus.
#include "core/stencils/stencil_shape.h"

namespace whorl {

extern const StencilShape chessboard, manhattan, subsampling, jittered;

Registry<StencilShape>& StencilShape::list() {
    static Registry<StencilShape> list("stencil", {&chessboard,   //
                                                   &manhattan,    //
                                                   &subsampling,  //
                                                   &jittered});
    return list;
}

}  // namespace whorl
