// The version that is built into the library.
#include <sunfleck/version.h>

namespace sunfleck {

const char* version() {
    return SUNFLECK_VERSION;
}

}  // namespace sunfleck
