// Lists the additions, a line each, before the first scene is made; then runs the tests.
#include <gtest/gtest.h>

#include "app/panels/list.h"
#include "app/window/lists.h"
#include "tests/extend/additions.h"
#include "tests/extend/toys.h"

namespace whorl::test {
namespace {

void list_additions() {
    // Scalars and phases first: measures and views are made from them.
    add_scalar(dye_info);
    phases().add(friction);
    step_orders().add(rough);
    measures().add(dye_height);
    derived_fields().add(kinetic);
    app::add_view(root_density);
    EditVerb::list().add(drop);
    app::tools().add(dropper);
    app::panels().add(dye_panel);
    list_toys();
}

}  // namespace
}  // namespace whorl::test

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    whorl::test::list_additions();
    return RUN_ALL_TESTS();
}
