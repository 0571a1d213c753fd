package frustum.referee

import frustum.budgets.{Budget, BudgetTable}
import frustum.command.render.EndToEndBounds
import frustum.driver.raster.PreparedFrame
import frustum.engine.raster.RasterEngines
import frustum.judge.{EndToEndJudge, EndToEndVerdict, FrameJudge}
import org.scalatest.funsuite.AnyFunSuite

/** A fault of the driver that model, reference and hardware would all follow is found by the referee. */
class PlantedFaultsTest extends AnyFunSuite {
  private val judge = new FrameJudge(RasterEngines.model, simulated = false)
  private val bound = BudgetTable.read(EndToEndBounds.Table).rows
    .find(b => b.scene == Budget.AnyPicture && b.metric == "endToEnd.unexplainedPercent").get.bound

  private def verdict(asked: Request, frame: PreparedFrame): EndToEndVerdict = {
    val (_, picture, logs) = judge.drawModel(frame)
    EndToEndJudge.judge(asked.view, frame, logs, picture)
  }

  private def found(v: EndToEndVerdict) = Seq(v.world, v.counts).distinct

  test("the frames that faults are planted in are without fault") {
    for (asked <- PlantedFaults.all.map(_.asked).distinct; e <- found(verdict(asked, asked.prepare)))
      assert(e.unexplainedPercent <= bound, s"${asked.scene.name}, ${asked.options}: $e")
  }

  for (fault <- PlantedFaults.all) test(s"the referee finds: ${fault.name}") {
    for (e <- found(verdict(fault.asked, fault.faulty))) {
      info(f"${e.referee}%-8s ${e.unexplainedPercent}%6.2f %% unexplained, bound $bound %%: " +
        f"${e.primitiveUnexplained} primitives, ${e.texelsUnexplained} texels, ${e.colorWrong} colours of ${e.judged}")
      assert(e.unexplainedPercent > 10 * bound, e)
    }
  }
}
