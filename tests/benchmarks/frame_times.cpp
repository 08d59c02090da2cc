// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// How long the GUI thread is away from its events while the preview is used: for each thing that a user does, the
// longest event (of all that Qt delivers until the picture has converged), and how long the first new frame took. Then,
// while a slider is dragged, the time from each step to the picture with it.
//   gonio_frame_times [width height [sliders]]     (sliders: only the last)
#include <QApplication>
#include <QElapsedTimer>
#include <QThread>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string_view>

#include "core/materials/material.h"
#include "core/models/model.h"
#include "core/rendering/scene_file.h"
#include "widgets/preview/preview_input.h"
#include "widgets/preview/preview_widget.h"

namespace {

using namespace gonio;
using namespace gonio::rendering;
using widgets::CompareMode;
using widgets::PreviewSubject;
using widgets::PreviewWidget;

/// CPU time of the calling thread, ms.
double threadMilliseconds() {
#ifdef CLOCK_THREAD_CPUTIME_ID
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return double(time.tv_sec) * 1e3 + double(time.tv_nsec) * 1e-6;
#else
  return 0;
#endif
}

/// Measures the events of the GUI thread; nested deliveries count with the outermost.
class TimedApplication : public QApplication {
 public:
  using QApplication::QApplication;

  struct Event {
    double milliseconds = 0;
    double cpuMilliseconds = 0;  ///< of the GUI thread: the rest of the time it waited, maybe for other programs
    QString what;
  };
  Event longest;

  bool notify(QObject* receiver, QEvent* event) override {
    if (QThread::currentThread() != thread() || depth_ > 0) return QApplication::notify(receiver, event);
    ++depth_;
    const QString what = QString("%1, %2").arg(receiver->metaObject()->className()).arg(int(event->type()));
    const double cpu = threadMilliseconds();
    timer_.start();
    const bool result = QApplication::notify(receiver, event);
    if (const double taken = double(timer_.nsecsElapsed()) * 1e-6; taken > longest.milliseconds)
      longest = {taken, threadMilliseconds() - cpu, what};
    --depth_;
    return result;
  }

 private:
  int depth_ = 0;
  QElapsedTimer timer_;
};

PreviewSubject modelAlone(const char* id, double roughness) {
  const models::Model& model = models::findModel(id);
  widgets::StandaloneModel shown{&model, models::defaultParameters(model.spec())};
  if (const auto place = model.spec().find("roughness")) shown.parameters.values[*place] = Rgb(roughness);
  return {shown};
}

class Session {
 public:
  Session(TimedApplication& application, const QSize& size) : application_(application) {
    preview_.resize(size);
    preview_.show();
    QObject::connect(&preview_, &PreviewWidget::frameRendered, [this] {
      if (firstFrame_ < 0) firstFrame_ = double(clock_.nsecsElapsed()) * 1e-6;
    });
    std::printf("%-36s %14s %14s %14s   %s\n", "what the user does", "longest event", "of it CPU", "first frame",
                "receiver and type of the event (times in ms)");
  }

  /// An edit of three lobes in the studio.
  void runSliders() {
    std::printf("\n%-36s %14s %14s   (steps every 16 ms or when the last is shown)\n", "slider to new picture, ms",
                "median", "longest");
    preview_.content().showScene(sphereScene(studioEnvironment()));
    const models::Model& model = models::findModel("layered");
    editing::DifferentialEdit edit = editing::unchangedEdit(model, models::defaultParameters(model.spec()));
    const auto rgl = materials::readMaterial("library:rgl/satin_purple").brdf;
    for (const auto& [base, name] : {std::pair{rgl, "RGL file, studio, three lobes"},
                                     {std::shared_ptr<const Brdf>(bakeTable(*rgl)), "table, studio, three lobes"}}) {
      const auto density = std::make_shared<const TabulatedDensity>(*base);
      measureSteps(name, [&](int step) {
        edit.edited = edit.fitted;
        for (std::size_t i = 0; i < edit.edited.values.size(); ++i)
          if (model.spec().parameters[i].id.find("roughness") != std::string_view::npos)
            edit.edited.values[i] *= 1 + 0.01 * (step + 1);
        preview_.content().setSubject({widgets::EditedMaterial{base, {{edit}}}, density});
      });
    }
  }

  void run() {
    const PreviewSubject ggx = modelAlone("ggx", 0.3);
    const auto table = bakeTable(*widgets::subjectBrdf(ggx));
    const auto density = std::make_shared<const TabulatedDensity>(*table);
    measure("nothing: the empty window", [](int) {});
    measure("open a material", [&](int) { preview_.content().setSubject(widgets::measuredSubject(table, density)); });
    measure(
        "exposure", [&](int step) { preview_.setExposure(0.05 * step); }, 20);
    measure("choose a model (new shader)", [&](int) { preview_.content().setSubject(ggx); });
    measure("choose another model (new shader)",
            [&](int) { preview_.content().setSubject(modelAlone("cook-torrance", 0.3)); });
    measure(
        "drag a slider", [&](int step) { preview_.content().setSubject(modelAlone("ggx", 0.1 + 0.01 * step)); }, 60);
    const auto orbit = [&](int) {
      preview_.content().setView(widgets::orbited(preview_.content().scene().camera, 4, 0), 0);
    };
    measure("orbit", orbit, 60);
    const Scene spheres = openScene("two-spheres"), bowl = openScene("bowl");
    measure("another scene (new shader)", [&](int) { preview_.content().showScene(spheres); });
    measure("orbit", orbit, 60);
    preview_.content().setSecond(widgets::measuredSubject(table, density), "Other");
    for (const auto& [mode, name] : {std::pair{CompareMode::split, "compare: split"},
                                     {CompareMode::difference, "compare: difference"},
                                     {CompareMode::twoUp, "compare: side by side"},
                                     {CompareMode::off, "compare: off"}})
      measure(name, [&, mode = mode](int) { preview_.content().setComparison({.mode = mode}); });
    measure(
        "resize", [&](int) { preview_.resize(preview_.size() + QSize(4, 2)); }, 20);
    measure("a mesh (new shader)", [&](int) { preview_.content().showScene(bowl); });
  }

 private:
  void process(int milliseconds) {
    QElapsedTimer timer;
    timer.start();
    do {
      QCoreApplication::processEvents(QEventLoop::AllEvents, milliseconds);
    } while (timer.elapsed() < milliseconds);
  }

  /// @param act one step of the hand; they come every 16 ms.
  void measure(const char* what, const std::function<void(int step)>& act, int steps = 1) {
    constexpr int longestWaitMs = 15000, settleMs = 300;
    application_.longest = {};
    firstFrame_ = -1;
    clock_.start();
    for (int step = 0; step < steps; ++step) {
      QMetaObject::invokeMethod(
          &preview_, [&act, step] { act(step); }, Qt::QueuedConnection);
      process(16);
    }
    process(settleMs);
    while (preview_.content().hasMaterial() && !preview_.converged() && clock_.elapsed() < longestWaitMs) process(20);
    const TimedApplication::Event& event = application_.longest;
    std::printf("%-36s %14.1f %14.1f %14.1f   %s\n", what, event.milliseconds, event.cpuMilliseconds, firstFrame_,
                qPrintable(event.what));
    std::fflush(stdout);
  }

  /// Waiting without sleep would take a core from the rendering.
  static void rest() {
    QCoreApplication::processEvents();
    QThread::usleep(300);
  }

  void measureSteps(const char* what, const std::function<void(int step)>& act) {
    constexpr int first = 5, steps = 40, stepMs = 16, longestWaitMs = 20000;  // the first ones compile the shader
    std::vector<double> times;
    for (int step = 0; step < steps; ++step) {
      QElapsedTimer timer;
      timer.start();
      act(step);
      process(0);
      const int wanted = preview_.lastRequest();
      while (preview_.shownRequest() < wanted && timer.elapsed() < longestWaitMs) rest();
      if (step >= first) times.push_back(double(timer.nsecsElapsed()) * 1e-6);
      while (timer.elapsed() < stepMs) rest();
      if (step + 1 == first)
        while (timer.elapsed() < 4000) rest();
    }
    std::ranges::sort(times);
    std::printf("%-36s %14.1f %14.1f\n", what, times[times.size() / 2], times.back());
    std::fflush(stdout);
  }

  TimedApplication& application_;
  PreviewWidget preview_;
  QElapsedTimer clock_;
  double firstFrame_ = -1;
};

}  // namespace

int main(int argc, char** argv) {
  TimedApplication application(argc, argv);
  const QSize size = argc > 2 ? QSize(std::atoi(argv[1]), std::atoi(argv[2])) : QSize(900, 700);
  Session session(application, size);
  const bool onlySliders = argc > 3 && std::string_view(argv[3]) == "sliders";
  if (!onlySliders) session.run();
  session.runSliders();
}
