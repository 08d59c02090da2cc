// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QSize>
#include <QString>
#include <QStringList>

#include "app/gonio/window/prepared_view.h"

class QApplication;

namespace gonio::app {

/// The command line of the editor. All options but help and version are for the scripts of the project, and hidden.
struct StartOptions {
  QStringList files;   // materials and documents, as given
  QString screenshot;  // saves a picture of the window as this file, and ends
  QSize size;          // of the window; invalid: as it was last
  double waitSeconds;  // at most, before the picture is taken
  QString theme;       // empty: as it was last
  QString thumbnails;  // renders the pictures of the library into this folder, and ends
  QString figure;      // measures the figure of this description; its dialog is the picture
  bool openingTimes;   // prints how long the files take to open, and ends
  bool eventTimes;     // prints at the end how long events kept the window from answering
  PreparedView view;
};

/// Reads the command line. Ends the program after help, the version or an error, with a message.
StartOptions readOptions(const QApplication& application);

}  // namespace gonio::app
