// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#include "tegata/export/viewer_page.h"

#include "tegata/base/error.h"

// The assembler copies the file as it is, which costs no time; a string literal of this size would.
#ifdef TEGATA_VIEWER_FILE
__asm__(
    ".pushsection .rodata\n"
    ".hidden tegata_viewer_page_begin\n"
    ".hidden tegata_viewer_page_end\n"
    ".global tegata_viewer_page_begin\n"
    ".global tegata_viewer_page_end\n"
    "tegata_viewer_page_begin:\n"
    ".incbin \"" TEGATA_VIEWER_FILE
    "\"\n"
    "tegata_viewer_page_end:\n"
    ".byte 0\n"
    ".popsection\n");
extern "C" const char tegata_viewer_page_begin[];  // NOLINT: the assembler's array
extern "C" const char tegata_viewer_page_end[];    // NOLINT
#endif

namespace tegata {

std::string_view viewer_page() {
#ifdef TEGATA_VIEWER_FILE
  return {tegata_viewer_page_begin, tegata_viewer_page_end};
#else
  return {};
#endif
}

void require_viewer_page() {
  if (!viewer_page().empty()) return;
  throw Error(
      "report page: this program was built without it (TEGATA_VIEWER=OFF); build it with "
      "-DTEGATA_VIEWER=ON");
}

}  // namespace tegata
