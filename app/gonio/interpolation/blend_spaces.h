// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QObject>
#include <QPointF>
#include <array>

#include "app/gonio/document/background_task.h"
#include "core/models/registry.h"
#include "widgets/interpolation/prepared_blend.h"

namespace gonio::app {

/// How the small spheres are drawn.
struct StripPictures {
  int side = 112, samples = 16;
};

/// Prepares materials for every space of interpolation, one space after the other in the background, and draws the
/// small spheres that show them side by side.
class BlendSpaces : public QObject {
  Q_OBJECT

 public:
  using Space = editing::InterpolationSpace;
  static constexpr int pictureCount = 7;  ///< t = 0, 1/6, .. 1 on the way of widgets::wayPlace()
  enum class State { waiting, running, ready, failed, cancelled };

  explicit BlendSpaces(BackgroundTasks& tasks, QObject* parent = nullptr, const StripPictures& pictures = {});

  /// The spaces that can be offered, in the order in which they are shown.
  const std::vector<Space>& spaces() const { return m_spaces; }

  /// Materials, or none. Of the same ones in another order, or after none, all that was prepared stays. Of others it is
  /// prepared anew when it is wanted, also what was found of a material that stays: that is about a second a material
  /// in the background, and the nodes and dictionaries of the blend depend on all of them.
  void setEnds(std::vector<editing::InterpolationEnd> ends);
  /// Of the spaces `parameters` and `differential`, which are prepared anew.
  void setModel(const models::Model& model);
  const models::Model& model() const { return *m_model; }
  static bool usesModel(Space space) { return space == Space::parameters || space == Space::differential; }
  bool hasEnds() const { return m_complete; }
  /// Where the material of each place stands in prepared(): in the order in which they were first set.
  const std::vector<std::size_t>& order() const { return m_order; }
  /// Weights of the places as prepared() takes them.
  std::vector<double> ordered(const std::vector<double>& weights) const;
  /// Begins or goes on, with this space first; also after a cancel or a failure of it.
  void want(Space first);
  /// No more work until want().
  void pause();

  State state(Space space) const { return entry(space).state; }
  QString failure(Space space) const { return entry(space).failure; }
  /// Null until it is there; before its pictures are.
  widgets::PreparedBlendPtr prepared(Space space) const { return entry(space).prepared; }
  /// Empty until they are there.
  const std::vector<QImage>& pictures(Space space) const { return entry(space).pictures; }
  /// Nothing runs and nothing waits.
  bool isSettled() const;

 Q_SIGNALS:
  /// The state of a space, or what is there of it.
  void changed(gonio::editing::InterpolationSpace space);

 private:
  struct Entry {
    State state = State::waiting;
    widgets::PreparedBlendPtr prepared;
    std::vector<QImage> pictures;
    QString failure;
  };
  const Entry& entry(Space space) const {
    static const Entry none;
    return m_complete ? m_entries[std::size_t(space)] : none;
  }
  Entry& entry(Space space) { return m_entries[std::size_t(space)]; }
  void turnPictures();
  void next();
  void prepare(Space space);
  void draw(Space space);
  void fail(Space space, const QString& error);
  void cancelAll();

  BackgroundTasks& m_tasks;
  StripPictures m_stripPictures;
  std::vector<Space> m_spaces;
  std::vector<editing::InterpolationEnd> m_ends;  ///< in the order in which they are prepared
  std::vector<std::size_t> m_order;
  bool m_complete = false;
  const models::Model* m_model = &models::ggx();
  std::array<Entry, editing::interpolationSpaceNames.size()> m_entries;
  Space m_first = Space::linear;
  bool m_wanted = false;
};

}  // namespace gonio::app
