package frustum.charts.systems

import frustum.contract.raster.RasterConfig
import frustum.referee.EndToEnd
import frustum.scene.Scenes
import org.scalatest.funsuite.AnyFunSuite

class SystemErrorsTest extends AnyFunSuite {
  private val base = RasterConfig(width = 96, height = 96)

  test("wrong triangles and texels are counted in per cent of the judged pixels") {
    val counts = EndToEnd("world", judged = 400, primitiveWrong = 3, texelsWrong = 5, 1, 1, 7, 0)
    assert(SystemError(0.25, counts) == SystemError(0.25, 2.0))
    assert(SystemError(0, counts.copy(judged = 0, primitiveWrong = 0, texelsWrong = 0)).wrongPercent == 0)
  }

  test("fewer bits, coarser vertices and affine mapping are worse end to end than the shipped system") {
    import SystemConfiguration.{Affine, Coordinates, Shipped, Vertices}
    def errors(name: String): (String, String) => SystemError = {
      val scene = Scenes.byName(name)
      val judge = new SystemErrors(scene, base.width, base.height)
      val all = SystemConfiguration.all(scene, base)
      (group, setting) => judge(all.find(c => c.group == group && c.setting.startsWith(setting)).get)
    }
    val (floor, cube) = (errors("floor"), errors("cube"))
    val worse = Seq(floor(Coordinates, "20"), floor(Vertices, "0"), floor(Affine, "whole"))
    for (e <- worse; shipped = floor(Shipped, ""))
      assert(e.wrongPercent > shipped.wrongPercent && e.flip > shipped.flip, s"$e, shipped $shipped")
    val spans = Seq("spans of 8", "spans of 16", "whole").map(cube(Affine, _).wrongPercent)
    assert(cube(Shipped, "").wrongPercent < spans.head && spans == spans.sorted, spans)
  }

  test("hardware made for a scene draws it as the shipped one does") {
    for (name <- Seq("cube", "teapot")) {
      val scene = Scenes.byName(name)
      val judge = new SystemErrors(scene, base.width, base.height)
      val all = SystemConfiguration.all(scene, base)
      val own = all.filter(_.group == SystemConfiguration.Scene)
      assert(own.nonEmpty && own.forall(_.config != base))
      val shipped = judge(all.head)
      for (c <- own) assert((judge(c).wrongPercent - shipped.wrongPercent).abs < 0.5, s"$name, ${c.setting}")
    }
  }

  test("fewer bits of the picture are farther in FLIP and leave the texels as they are") {
    val scene = Scenes.byName("cube")
    val judge = new SystemErrors(scene, base.width, base.height)
    val all = SystemConfiguration.all(scene, base)
    val shipped = judge(all.head)
    val pictures = all.filter(_.group == SystemConfiguration.Picture)
    val errors = pictures.map(judge(_))
    assert(errors.map(_.wrongPercent).forall(_ == shipped.wrongPercent))
    assert((shipped +: errors).map(_.flip) == (shipped +: errors).map(_.flip).sorted)
    assert(pictures.map(_.shown(0xffffff)).forall(_ == 0xffffff) && pictures.head.shown(0x8f1234) == 0x881133)
  }

  test("a scene without textures has no configurations that only textures feel") {
    val groups = SystemConfiguration.all(Scenes.byName("teapot"), base).map(_.group)
    assert(!groups.contains(SystemConfiguration.Coordinates) && !groups.contains(SystemConfiguration.Affine))
    assert(groups.contains(SystemConfiguration.Colors))
  }
}
