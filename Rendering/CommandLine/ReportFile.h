// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief an HTML page of sections to which several processes may add at once
 *
 * The page is a single file without dependencies. To add a section, a process locks the file, reads
 * it, replaces the section of the same name or appends a new one, and writes the file again. So
 * tests that run in parallel share a page, a repeated test has one section, and no final merge is
 * needed.
 */

#ifndef ReportFile_h
#define ReportFile_h

#include <string>

namespace lambent::command
{

/// Escapes text for HTML.
std::string EscapeHtml(const std::string& text);

/// Throws Failure if the file cannot be written, or exists and is not a report.
void AddToReport(const std::string& path, const std::string& name, const std::string& section);

} // namespace lambent::command

#endif
