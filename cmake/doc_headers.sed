# The comment at the top of a header describes the file; an example's code is set as such.
1,/^#pragma once/{
  s#^//( |$)#///\1#
  1s#^///#/// \\file\n///#
}
