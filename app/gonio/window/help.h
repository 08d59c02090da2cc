// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QDialog>
#include <vector>

class QListWidget;
class QTextBrowser;

namespace gonio::app {

struct NamedAction;

/// A page of the built-in documentation: a file of docs/ (complete, see cmake/Pages.cmake), or a heading in it. The
/// laboratory notes (docs/results) are not built in.
struct GuidePage {
  QString file;   ///< e.g. "editor.md"
  QString title;  ///< e.g. "The editor", "Export Image"
  int level = 1;  ///< 1: the page itself
};

/// All pages, each followed by its second-level headings: Getting started, then in the order of the index.
const std::vector<GuidePage>& guidePages();

/// Help > Guide: the documentation, with links between its pages.
class GuideWindow : public QDialog {
  Q_OBJECT

 public:
  explicit GuideWindow(QWidget* parent);

  /// @param heading text of the heading; empty: the top of the page.
  void showPage(const QString& file, const QString& heading = {});
  QString page() const { return m_file; }
  QTextBrowser& text() const { return *m_text; }

 private:
  void follow(const QUrl& link);
  void setMarkdown(const QString& text);
  /// Scrolls to the first heading for which `fits` is true.
  void scrollTo(const std::function<bool(const QString&)>& fits);

  QListWidget* m_pages;
  QTextBrowser* m_text;
  QString m_file;
};

/// Opens a page in the guide of a window, in the existing guide window if it is open.
void openGuide(QWidget* window, const QString& file, const QString& heading = {});

/// Anchor of a heading in links: lower case, hyphens for spaces, no punctuation.
QString anchorOf(const QString& heading);

/// Table of all shortcuts, generated from the actions.
QString shortcutsPage(const QList<NamedAction>& actions);
/// All models with their parameters, formulae and sources, generated from their specs.
QString formulaePage();
/// Description, version and licence of Gonio, and the licences of its dependencies.
QString aboutPage();

/// Shows a page in a separate, non-modal window.
void showPage(const QString& title, const QString& html, QWidget* parent);

}  // namespace gonio::app
