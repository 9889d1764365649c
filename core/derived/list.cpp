// Every derived field, a line each.
#include "core/derived/derived.h"

namespace whorl {

extern const DerivedField speed, vorticity_field, divergence;

Registry<DerivedField>& derived_fields() {
    static Registry<DerivedField> all("derived field", {
                                                           &speed,            //
                                                           &vorticity_field,  //
                                                           &divergence,       //
                                                       });
    return all;
}

}  // namespace whorl
