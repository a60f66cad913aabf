// SPDX-FileCopyrightText: 2026 The tegata authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tegata/export/exported_frames.h"

namespace tegata {

/// What a result can be exported to; docs/formats.md describes each.
enum class ExportFormat { urdf, bvh, csv, trc, mot, npz };
std::string_view export_format_name(ExportFormat format);
/// Throws Error listing the names that would do.
ExportFormat export_format_from_name(std::string_view name);

struct ExportOptions {
  /// Of a hand, for the inertials of a URDF [kg/m^3]: Dempster, Space requirements of the seated
  /// operator, WADC TR 55-159, 1955, table 14 has 1.16 times that of water.
  double density = 1160.0;
};

/// A result in another format.
struct Export {
  std::vector<ExportedFile> files;  ///< one, but for a URDF
  std::vector<std::string> notes;   ///< what the format cannot say and a user should know
};

/// Throws Error where the hand is not the one that was fitted, and where a format that has no way
/// to leave frames out has no pose to show.
Export export_result(const Result& result, const HandModel& hand, ExportFormat format,
                     const ExportOptions& options = {});

}  // namespace tegata
