package frustum.scene

import frustum.contract.arithmetic.IntVector
import frustum.contract.InputError
import frustum.contract.ray.{
  RayBox,
  RayCamera,
  RayCameraRange,
  RayChecker,
  RayImage,
  RayQuad,
  RayRoom,
  RayScene,
  RaySolid,
  RaySphere
}
import frustum.demos.pong.PongScene
import org.scalatest.funsuite.AnyFunSuite

import java.nio.file.Files

class RaySceneFileTest extends AnyFunSuite {
  private val base = PongScene.room()
  private val file = Files.createTempFile("scene", ".json")
  private def read(content: String) = {
    Files.writeString(file, content); RaySceneFile.read(file, base, 640, 480)
  }

  test("what is left out is the base's") {
    assert(read("{}") == base)
    assert(read("""{"light": null, "background": "102030"}""") == base.copy(
      light = None,
      background = 0x102030
    ))
  }

  test("every part") {
    val scene = read("""{
      "camera": {"eye": [10, 0, -300], "focal": 400},
      "room": {"low": [-320, -240, 0], "high": [320, 240, 500], "cellBits": 5},
      "spheres": [{"low": [-50, -50, 100], "high": [50, 50, 300], "radius": 30, "color": "00ff80"},
                  {"centre": [200, 0, 200], "radius": 10, "color": "ffffff"}],
      "quads": [{"centre": [0, 0, 500], "half": 40, "color": "0000ff"}],
      "light": [1, 2, 3]}""")
    assert(scene == RayScene(
      RayCameraRange(RayCamera.forward(IntVector(10, 0, -300), 640, 480, 400)),
      RayRoom(IntVector(-320, -240, 0), IntVector(320, 240, 500), 5),
      Seq(
        RaySphere(IntVector(-50, -50, 100), IntVector(50, 50, 300), 30, 0x00ff80),
        RaySphere(IntVector(200, 0, 200), IntVector(200, 0, 200), 10, 0xffffff)
      ),
      Seq(RayQuad(IntVector(0, 0, 500), IntVector(0, 0, 500), 40, 0x0000ff)),
      Some(IntVector(1, 2, 3)),
      base.background
    ))
    val turned = read(
      """{"camera": {"eye": [0, 0, -300], "corner": [-1, -2, 3], "right": [1, 0, 0], "down": [0, 1, 0]}}"""
    )
    assert(turned.camera.low.direction(2, 3) == IntVector(1, 1, 3))
  }

  test("a camera that moves") {
    val scene = read("""{"camera": {"lengths": [300, 900],
      "low":  {"eye": [-10, 0, -300], "corner": [-700, -700, -700], "right": [-2, -2, -2], "down": [-2, -2, -2]},
      "high": {"eye": [10, 0, -200], "corner": [700, 700, 700], "right": [2, 2, 2], "down": [2, 2, 2]}}}""")
    assert(!scene.camera.fixed && scene.camera.lengths.contains((300, 900)))
    assert(scene.eye == RayBox(IntVector(-10, 0, -300), IntVector(10, 0, -200)))
  }

  test("paints: checkers, colours, images beside the file") {
    val texels = IndexedSeq(0x112233, 0x445566, 0x778899, 0xaabbcc, 1, 2, 3, 4)
    frustum.picture.Picture.writePng(file.resolveSibling("paint.png"), 4, 2, texels.toArray)
    val scene = read("""{"room": {"low": [-320, -240, 0], "high": [320, 240, 640], "cellBits": 6, "walls":
      {"left": {"color": "102030"}, "back": {"image": "paint.png", "texelBits": 3}, "floor": {"cellBits": 4}}},
      "quads": [{"centre": [0, 0, 640], "half": 50, "image": "paint.png", "texelBits": 1}]}""")
    assert(scene.room.paints == Seq(
      RaySolid(0x102030),
      RayChecker(6),
      RayChecker(4),
      RayChecker(6),
      RayImage(4, 2, 3, texels)
    ))
    assert(scene.quads.map(_.paint) == Seq(RayImage(4, 2, 1, texels)))
    frustum.picture.Picture.writePng(file.resolveSibling("odd.png"), 3, 2, texels.take(6).toArray)
  }

  private def back(paint: String) =
    s"""{"room": {"low": [-320, -240, 0], "high": [320, 240, 640], "cellBits": 6, "walls": {"back": $paint}}}"""
  private val bad = Seq(
    """{"camera": {"low": {}, "high": {}}}""" -> Seq("camera", "'lengths'"),
    """{"camera": {"low": {}, "high": {}, "lengths": [1, 2]}}""" -> Seq("camera.low", "'eye'"),
    """{"camera": {"low": {}, "high": {}, "lengths": 3}}""" -> Seq("camera.lengths", "list"),
    back("""{"image": "none.png", "texelBits": 1}""") -> Seq("none.png", "no such picture"),
    back("""{"image": "odd.png", "texelBits": 1}""") -> Seq("odd.png", "3 x 2", "power of two"),
    back("""{"image": "paint.png"}""") -> Seq("room.walls.back", "'texelBits'"),
    back("""{"image": "paint.png", "texelBits": 13}""") -> Seq("2^13", "2^12"),
    back("""{"colour": "ffffff"}""") -> Seq("room.walls.back", "'colour'"),
    back("""{"image": "paint.png", "color": "ffffff"}""") -> Seq("room.walls.back", "one of them"),
    "{\n\"light\": [1,2\n}" -> Seq(":3: ", "JSON"),
    "{" -> Seq("JSON"),
    "[]" -> Seq("scene", "no object"),
    """{"lamp": [0,0,0]}""" -> Seq("'lamp'", "light"),
    """{"light": [0,0]}""" -> Seq("light", "[x, y, z]"),
    """{"light": [0,0,0.5]}""" -> Seq("light", "0.5", "whole"),
    """{"background": "red"}""" -> Seq("background", "hexadecimal"),
    """{"camera": {"eye": [0,0,0], "focal": 0}}""" -> Seq("camera.focal", "at least 1"),
    """{"camera": {"eye": [0,0,0], "focal": -320}}""" -> Seq("camera.focal", "at least 1"),
    """{"camera": {"eye": [0,0,0], "corner": [1,2,3], "right": [0,0,0], "down": [0,1,0]}}""" -> Seq(
      "one plane",
      "(0, 0, 0)"
    ),
    """{"camera": {"eye": [0,0,0], "corner": [-320,240,320], "right": [1,0,0], "down": [2,0,0]}}""" -> Seq("one plane"),
    """{"camera": {"eye": [0,0,0]}}""" -> Seq("camera", "'corner'"),
    """{"spheres": {"centre": [0,0,100]}}""" -> Seq("spheres", "list"),
    """{"spheres": [{"centre": [0,0,100], "color": "ff0000"}]}""" -> Seq("spheres[0]", "'radius'"),
    """{"spheres": [{"centre": [0,0,100], "low": [0,0,0], "radius": 1, "color": "ff0000"}]}""" -> Seq(
      "spheres[0]",
      "centre"
    ),
    """{"spheres": [{"centre": [0,0,100], "radius": 0, "color": "ff0000"}]}""" -> Seq("sphere 0", "radius 0"),
    """{"spheres": [{"centre": [0,0,-310], "radius": 20, "color": "ff0000"}]}""" -> Seq(
      "inside sphere 0",
      "20"
    ),
    """{"spheres": [{"centre": [0,0,100], "radius": 20, "color": "ff0000"},
      |  {"centre": [0,30,110], "radius": 12, "color": "00ff00"}]}""".stripMargin -> Seq(
      "spheres 0 and 1 may intersect",
      "20 and 12",
      "1000",
      "1024"
    ),
    """{"light": [0,0,9000]}""" -> Seq("outside the room", "9000")
  )
  for ((content, fragments) <- bad) test(s"refused: ${content.replaceAll("\\s+", " ")}") {
    val e = intercept[InputError](read(content))
    assert(e.message.startsWith(s"${file.getParent}") && !e.message.contains('\n'), e.message)
    fragments.foreach(f => assert(e.message.contains(f), e.message))
  }

  test("no such file") {
    val e = intercept[InputError](RaySceneFile.read(file.resolveSibling("none"), base, 640, 480))
    assert(e.message.contains("no such file"))
  }
}
