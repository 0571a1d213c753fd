package frustum.ray

import frustum.contract.ray.{RayScene, Wall}
import frustum.harness.{FrustumSim, Simulated}
import frustum.ray.scene.RayConfig
import org.scalatest.funsuite.AnyFunSuite

import java.nio.file.Files
import scala.util.control.NonFatal

/** A scene may have any number of each kind of object, none included. */
class RayCountsTest extends AnyFunSuite with RayEquality {
  import CountedScenes.{mode, paints}
  private lazy val directory = Files.createTempDirectory("rayCounts")

  private def elaborates(what: String, scene: => RayScene, fast: Boolean = false): Unit =
    try FrustumSim.spinalConfig
        .copy(targetDirectory = directory.toString, verbose = false)
        .generateVerilog(RayPipeline(RayConfig(scene, mode, fast)))
    catch { case NonFatal(e) => fail(s"$what: $e") }

  test("every number of spheres and quads, with and without light, is elaborated") {
    val least = Seq(0, 1)
    for {
      spheres <- 0 to RayScene.MaxSpheres
      quads <- 0 to RayScene.MaxQuads
      if least.contains(spheres) || quads == 0 || quads == RayScene.MaxQuads
      light <- if (quads == 0 || spheres == 0) Seq(false, true) else Seq(true)
    } elaborates(s"$spheres spheres, $quads quads, light $light", CountedScenes(spheres, quads, light))
  }
  test("every number of moving objects is elaborated") {
    for (moving <- 0 to 4; fast <- Seq(false, true))
      elaborates(s"$moving moving, fast $fast", CountedScenes(4, 4, moving = moving), fast)
  }
  test("every number of checkers, images and plain walls is elaborated") {
    for (checkers <- 0 to Wall.all.size; images <- 0 to Wall.all.size - checkers) {
      val quads = (checkers + images) % (RayScene.MaxQuads + 1)
      elaborates(
        s"$checkers checkers, $images images, $quads quads",
        CountedScenes(quads = quads, paints = paints(checkers, images))
      )
    }
  }

  private val (mostSpheres, mostQuads) = (RayScene.MaxSpheres, RayScene.MaxQuads)
  test("nothing but walls", Simulated)(compare("walls", CountedScenes(light = false), 1, 21, mode))
  test("nothing but walls of one colour and a light", Simulated)(
    compare("plainWalls", CountedScenes(paints = paints(0, 0)), 1, 22, mode)
  )
  test("spheres without quads", Simulated)(compare("noQuads", CountedScenes(2, 0, moving = 1), 2, 23, mode))
  test("most spheres and quads, all moving, with light", Simulated)(
    compare("most", CountedScenes(mostSpheres, mostQuads, moving = mostSpheres, paints = paints(2, 3)), 2, 24, mode)
  )
  test("most quads without spheres or light", Simulated)(
    compare("quads", CountedScenes(0, mostQuads, light = false, moving = 2, paints = paints(0, 5)), 2, 25, mode)
  )
}
