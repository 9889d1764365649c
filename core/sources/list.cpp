// Every kind of edit, a line each.
#include "core/sources/edit.h"

namespace whorl {

extern const EditVerb smoke_verb, push_verb, build_verb, erase_verb;

Registry<EditVerb>& EditVerb::list() {
    static Registry<EditVerb> all("edit", {
                                              &smoke_verb,  //
                                              &push_verb,   //
                                              &build_verb,  //
                                              &erase_verb,  //
                                          });
    return all;
}

}  // namespace whorl
