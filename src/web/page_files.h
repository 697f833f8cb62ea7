// The files of src/web/page as text; cmake/web_page.cmake writes what stands behind this.
#pragma once

namespace collision_hulls {

const char* pageStyle();
const char* pageScript();  ///< all scripts, one after another

}  // namespace collision_hulls
