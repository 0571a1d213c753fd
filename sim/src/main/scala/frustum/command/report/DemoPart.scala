package frustum.command.report

import frustum.command.demo.DemoPage
import frustum.scene.Scenes

/** Every scene of `demo` with its pictures. */
object DemoPart extends ReportPart("The demo scenes", "demo", "demo") {
  private val order = Scenes.names ++ Seq("pong", "voxel")

  def shown(files: ReportFiles): Option[Shown] = {
    val reports = files.ofKind(".json").map(f => files.read(f)(r => (r, pictures(files, r))))
      .sortBy(r => order.indexOf(r._1("scene").str))
    Option.when(reports.nonEmpty) {
      val wrong = reports.map(_._1).filterNot(right)
      Shown(
        DemoPage.body(files.folder, reports.map(_._1)),
        if (wrong.isEmpty) s"${reports.length} scenes, all as they should be"
        else s"wrong: ${wrong.map(_("scene").str).mkString(", ")}",
        wrong.isEmpty,
        files.ofKind(".json") ++ reports.flatMap(_._2) ++ files.find("index.html")
      )
    }
  }

  private def pictures(files: ReportFiles, r: ujson.Obj) = DemoPage.pictures(files.folder, r).map(_._1)

  /** What has to be 0 is. */
  private def right(r: ujson.Obj): Boolean = Seq(
    Seq("hardwareVsModel", "pixelsDifferent"),
    Seq("modelVsReference", "coverageWrong"),
    Seq("syncErrors"),
    Seq("silhouettePixelsWrong"),
    Seq("shadowPixelsWrong"),
    Seq("objectPixelsWrong"),
    Seq("checkerCellsWrong"),
    Seq("blocksWrong"),
    Seq("facesWrong"),
    Seq("texelsWrong")
  ).flatMap(_.foldLeft(Option[ujson.Value](r))((at, key) => at.flatMap(_.obj.get(key)))).forall(_.num == 0)
}
