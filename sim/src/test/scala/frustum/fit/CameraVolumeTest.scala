package frustum.fit

import frustum.driver.linear.Vector4
import frustum.driver.raster.Projection
import frustum.scene.MeshFiles._
import frustum.scene.ObjScene
import org.scalatest.funsuite.AnyFunSuite

class CameraVolumeTest extends AnyFunSuite {
  test("a framed mesh lies between the near and the far plane from every distance of a volume") {
    val mesh = square + "v 0 3 1\nf 1 2 3 4\nf 4 3 5\n"
    val scene = withFiles("m.obj" -> mesh)(d => ObjScene.read(d.resolve("m.obj")))
    val volume = CameraVolume((-30, 30), (-10, 10), (0.7, 3))
    val own = volume.framed(scene)
    for (turn <- Seq(-30.0, 30.0); distance <- Seq(0.7, 1.0, 3.0)) {
      val toClip = Projection(View(turn, 5, distance).camera(own), 0.75)
      for (v <- scene.triangles.flatMap(_.vertices)) {
        val c = toClip * Vector4.point(v.position)
        assert(c.z.abs < c.w, s"turn $turn, distance $distance")
      }
    }
  }
}
