// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <array>

#include "core/math/types.h"
#include "core/models/parameter_spec.h"

class QComboBox;
class QToolButton;

namespace gonio::widgets {

class ColourSwatch;
class ParameterLine;

/// One parameter as its spec describes it: a number, a choice, or three channels linked by one slider with a swatch
/// where they are a colour and a disclosure that shows a line for each channel.
class ParameterRow : public QWidget {
  Q_OBJECT

 public:
  explicit ParameterRow(const models::ParameterSpec& spec, QWidget* parent = nullptr);

  void setValue(const Rgb& value, const Rgb& reference);
  const models::ParameterSpec& spec() const { return *m_spec; }
  bool isModified() const { return m_value != m_reference; }
  /// Greyed while it does not matter; `reason` stands first in the tooltips then.
  void setActive(bool active, const QString& reason);
  /// Again, after the units of the program have changed.
  void showUnits();
  void setChannelsShown(bool shown);
  bool channelsShown() const;

 Q_SIGNALS:
  void editingStarted();
  void valueEdited(const gonio::Rgb& value);
  void editingFinished();
  void resetRequested();

 private:
  void buildNumber();
  void buildChannels();
  void buildChoice();
  void connectLine(ParameterLine* line);
  void offer(const Rgb& value);
  void refresh();
  void describe();

  const models::ParameterSpec* m_spec;
  Rgb m_value{0}, m_reference{0};
  QString m_inactiveReason;
  ParameterLine* m_line = nullptr;
  std::array<ParameterLine*, 3> m_channels{};
  QToolButton* m_disclosure = nullptr;
  ColourSwatch* m_swatch = nullptr;
  QComboBox* m_choice = nullptr;
};

}  // namespace gonio::widgets
