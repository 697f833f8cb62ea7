// Read when a page is written, not when this library is built: a package that is installed later serves the next page, and no copy of
// three.js is part of this library. It runs in the browser of whoever opens a page, so a file that others can write is none.
#include "web/three_js.h"

#include "base/string_parts.h"
#include "storage/trusted_file.h"

namespace collision_hulls {
namespace {

constexpr std::uintmax_t kMostBytes = std::uintmax_t{4} << 20;

/// Nothing that ends a <script>, or changes how its end is found.
bool fitsScript(const std::string& text) {
  const std::string lower = inLowerCase(text);
  return lower.find("</script") == std::string::npos && lower.find("<!--") == std::string::npos &&
         lower.find("<script") == std::string::npos;
}

}  // namespace

std::string threeJs(const std::filesystem::path& file) {
  const TrustedFile read = readTrustedFile(file.string(), kMostBytes);
  return fitsScript(read.content) ? read.content : "";
}

const char* threeJsNotice() {
  return R"(three.js, https://threejs.org - the MIT License
Copyright (c) 2010-2019 three.js authors
Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated documentation files (the
"Software"), to deal in the Software without restriction, including without limitation the rights to use, copy, modify, merge, publish,
distribute, sublicense, and/or sell copies of the Software, and to permit persons to whom the Software is furnished to do so, subject to the
following conditions: The above copyright notice and this permission notice shall be included in all copies or substantial portions of the
Software. THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF
MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY
CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE
SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.)";
}

}  // namespace collision_hulls
