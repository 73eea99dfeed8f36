// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief an HTML page of sections, which several processes may add to at once
 *
 * The page is one file that needs no other. Whoever has something to add locks it,
 * reads it, puts a section of its name into the place of an older one or at the end, and
 * writes it again. So tests that run in parallel share a page, a test that is
 * repeated has one section, and nobody has to join anything in the end.
 */

#ifndef ReportFile_h
#define ReportFile_h

#include <string>

namespace lambent::command
{

/// Text as HTML shows it.
std::string EscapeHtml(const std::string& text);

/// Throws Failure if the file cannot be written, or is there but not such a page.
void AddToReport(const std::string& path, const std::string& name, const std::string& section);

} // namespace lambent::command

#endif
