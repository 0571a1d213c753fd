package frustum.referee

import frustum.contract.voxel.{VoxelConfig, WorldSize}
import frustum.driver.linear.Vector3
import frustum.driver.voxel.VoxelView
import frustum.reference.voxel.{ExactMarch, IdealVoxelPicture}
import frustum.scene.{BlockFile, VoxelWorld}
import org.scalatest.funsuite.AnyFunSuite
import java.nio.file.Files

/** What the command line promises of voxel pictures, held against both derivations of it. */
class VoxelContractTest extends AnyFunSuite {
  private val c = VoxelConfig(WorldSize(8, 4, 16), 32, 24)
  private val focal = 225.0 * c.height / 240

  private def rays(yaw: Double, pitch: Double) =
    VoxelRays.ofAngles(Vec(1, 2, 3), yaw, pitch, focal, c.width, c.height)

  private def close(a: Vec, b: Vec) = (a - b).length < 1e-12

  test("yaw 0 looks along +x, 90 along +y; pitch is positive upwards; z is up") {
    assert(close(rays(0, 0).look, Vec(1, 0, 0)) && close(rays(90, 0).look, Vec(0, 1, 0)))
    assert(close(rays(0, 90).look, Vec(0, 0, 1)) && close(rays(0, -90).look, Vec(0, 0, -1)))
    assert(close(rays(0, 0).up, Vec(0, 0, 1)) && close(rays(0, 0).right, Vec(0, -1, 0)))
  }

  test("pixels to the right lie to the right, those below lie below") {
    for (yaw <- 0 until 360 by 30; r = rays(yaw, 10)) {
      assert((r.direction(31, 12) - r.direction(0, 12)).unit.dot(r.right) > 0.999)
      assert(r.direction(16, 0).z > r.direction(16, 23).z)
      // To the right of who looks along +x is -y, of who looks along +y is +x: look x up.
      assert(close(r.right, (r.look cross Vec(0, 0, 1)).unit))
    }
  }

  test("the driver's camera and its words are the contract's rays, from angles and from a direction") {
    for (yaw <- -170 to 180 by 37; pitch <- -85 to 85 by 17) {
      val view = VoxelView(Vector3(1, 2, 3), yaw, pitch, focal)
      val camera = view.camera(c)
      val look = view.look * 3
      val (y, p) = VoxelView.angles(look)
      val asked = VoxelView(Vector3(1, 2, 3), y, p, focal, Some(look))
      for (
        rays <- Seq(IdealVoxelPicture.rays(view, c), IdealVoxelPicture.rays(asked, c)); i <- Seq(0, 13, 31);
        j <- Seq(0, 7, 23)
      ) {
        val Seq(dx, dy, dz) = camera.direction(i, j).map(_.toDouble)
        assert(rays.error(i, j, Vec(dx, dy, dz)) < 0.02, s"yaw $yaw, pitch $pitch, pixel ($i, $j)")
      }
    }
  }

  test("a raw world's byte x sizeY sizeZ + y sizeZ + z is block (x, y, z)") {
    val file = Files.createTempFile("world", ".raw")
    val bytes = new Array[Byte](8 * 4 * 16)
    bytes(5 * 4 * 16 + 2 * 16 + 9) = 3
    Files.write(file, bytes)
    val world = VoxelWorld.readRaw(file, c.size, 24)
    val blocks = new WorldBlocks(world)
    for (x <- -1 to 8; y <- -1 to 4; z <- -1 to 16) {
      val expected = if ((x, y, z) == ((5, 2, 9))) 3 else 0
      assert(blocks(x, y, z) == expected && world(x, y, z) == expected, s"block ($x, $y, $z)")
    }
  }

  test("top is seen from above, bottom from below, side from the sides; pictures are upright") {
    val file = Files.createTempFile("blocks", ".json")
    Files.writeString(file, """[{"name": "b", "top": "snow", "bottom": "dirt", "side": "bark"}]""")
    val assets = BlockFile.read(file)
    val world = VoxelWorld.tabulate(c.size)((x, y, z) => if ((x, y, z) == ((4, 2, 8))) 1 else 0)
    val middle = Vector3(4.5, 2.5, 8.5)
    for (
      ((yaw, pitch), face) <- Seq(
        (0.0, 0.0) -> 0,
        (180.0, 0.0) -> 1,
        (90.0, 0.0) -> 2,
        (-90.0, 0.0) -> 3,
        (0.0, 90.0) -> 4,
        (0.0, -90.0) -> 5
      )
    ) {
      val look = rays(yaw, pitch).look
      val eye = middle - Vector3(look.x, look.y, look.z) * 2
      val view = VoxelView(eye, yaw, pitch, focal)
      val seen = new ExactMarch(
        c,
        assets.table,
        new WorldBlocks(world),
        view.camera(c).eye.axes,
        Seq(look.x, look.y, look.z).map(v => (v * 4096).round),
        Seq(look.x, look.y, look.z).map(_.round < 0)
      ).march()
      assert(seen.map(_.face) == Seq(face), s"yaw $yaw, pitch $pitch")
      // u to the right and v downwards for one who looks at a side, whose top is the block's.
      if (face < 4) {
        val r = IdealVoxelPicture.rays(view, c)
        val at = Seq(r.right * 0.3 + r.up * 0.2)
        val Seq(p) = at.map(o => Vec(0.5, 0.5, 0.5) + o)
        val (u, v) = ExactMarch.uv(face, Seq(p.x, p.y, p.z).map(k => (k * 16).toInt.min(15)))
        assert(u >= 11 && u <= 13 && v >= 3 && v <= 5, s"face $face: ($u, $v)")
      }
      val texture = assets.table(1).textures(face)
      val shown =
        new IdealVoxelPicture(c, assets, world, IdealVoxelPicture.rays(view, c)).pixel(c.width / 2, c.height / 2)
      val colors = for (v <- 0 until 16; u <- 0 until 16) yield assets.textures(texture, u, v) >> 12 & 15
      assert(
        colors.map(k => (k * 17 * VoxelConfig.Light(face) / 256.0).round).contains((shown >> 16).toLong),
        s"face $face"
      )
    }
  }
}
