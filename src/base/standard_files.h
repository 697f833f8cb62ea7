// Standard input, output and error, which whoever starts a program may have closed, or may not read.
#pragma once

namespace collision_hulls {

/// To be called first in main(). Without these files, the next one that is opened takes the place of one of them, and receives what is
/// meant for it. Puts /dev/null in the place of each that is closed: nothing is read, what is written to standard error goes nowhere, and
/// writing to standard output fails, as it did.
void holdStandardFiles();

/// Whether a line on standard output or error is written at once: nobody waits for the reader of a full pipe, or for a terminal that is
/// stopped. Always true of files, and of a pipe whose reader has gone.
bool takesLine(int file);

}  // namespace collision_hulls
