// Standard input, output and error, which whoever starts a program may have closed.
#pragma once

namespace collision_hulls {

/// To be called first in main(). Without these files, the next one that is opened takes the place of one of them, and receives what is
/// meant for it. Puts /dev/null in the place of each that is closed: nothing is read, what is written to standard error goes nowhere, and
/// writing to standard output fails, as it did.
void holdStandardFiles();

}  // namespace collision_hulls
