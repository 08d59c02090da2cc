// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QDialog>
#include <vector>

class QListWidget;
class QTextBrowser;

namespace gonio::app {

/// A page of the documentation that is built in: a file of docs/, or a heading on it.
struct GuidePage {
  QString file;   ///< "editor.md", "results/exports.md"
  QString title;  ///< "The editor", "Export Image"
  int level = 1;  ///< 1: the page itself
};

/// All pages with their headings of the second level below them; the editor's own page first, measured results last.
const std::vector<GuidePage>& guidePages();

/// The page that a link on a page leads to, as GuidePage::file: "../study.md" on "results/factors.md" is "study.md".
QString linkedPage(const QString& file, const QString& path);

/// Help > Guide: the documentation, with links between its pages.
class GuideWindow : public QDialog {
  Q_OBJECT

 public:
  explicit GuideWindow(QWidget* parent);

  /// @param heading as it reads; empty: the top of the page.
  void showPage(const QString& file, const QString& heading = {});
  QString page() const { return m_file; }
  QTextBrowser& text() const { return *m_text; }

 private:
  void follow(const QUrl& link);
  /// To the first heading that `fits`.
  void scrollTo(const std::function<bool(const QString&)>& fits);

  QListWidget* m_pages;
  QTextBrowser* m_text;
  QString m_file;
};

/// Opens a page in the guide of a window, in the one that is open already where there is one.
void openGuide(QWidget* window, const QString& file, const QString& heading = {});

/// What a link in the documentation calls a heading: lower case, hyphens for spaces, no punctuation.
QString anchorOf(const QString& heading);

}  // namespace gonio::app
