# `cmake --build build --target doc`: the public headers and the documents as HTML in build/html. Optional.

find_package(Doxygen QUIET)
if(DOXYGEN_FOUND)
  set(DOXYGEN_USE_MDFILE_AS_MAINPAGE README.md)
  set(DOXYGEN_JAVADOC_AUTOBRIEF YES)
  set(DOXYGEN_EXTRACT_ALL YES)  # a name that says it all has no comment
  set(DOXYGEN_QUIET YES)
  set(DOXYGEN_WARN_AS_ERROR YES)
  set(DOXYGEN_HAVE_DOT NO)
  # Doxygen 1.9 knows no GitHub anchors: links to a heading become links to its page, or text on the same page.
  set(DOXYGEN_FILTER_PATTERNS "*.md=sed -E -e 's/\\[([^]]*)\\]\\(#[^)]*\\)/\\1/g' -e 's/\\]\\(([^)#]+)#[^)]*\\)/](\\1)/g'")
  file(GLOB pages RELATIVE "${PROJECT_SOURCE_DIR}" CONFIGURE_DEPENDS doc/*.md doc/results/*.md)
  doxygen_add_docs(doc include README.md CONTRIBUTING.md ${pages} WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
endif()
