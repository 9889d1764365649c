// The list of interpolations, in the order of menus.
#include "core/interpolation/interpolation.h"

namespace whorl {

extern const Interpolation catmull_rom, monotone_catmull_rom, bridson, fritsch_carlson,
    fritsch_carlson_square, b_spline, bicubic;

Registry<Interpolation>& Interpolation::list() {
    static Registry<Interpolation> list("interpolation", {&linear,                  //
                                                          &catmull_rom,             //
                                                          &monotone_catmull_rom,    //
                                                          &bridson,                 //
                                                          &fritsch_carlson,         //
                                                          &fritsch_carlson_square,  //
                                                          &b_spline,                //
                                                          &bicubic});
    return list;
}

}  // namespace whorl
