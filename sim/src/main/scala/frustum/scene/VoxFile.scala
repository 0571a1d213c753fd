package frustum.scene

import frustum.contract.InputError
import frustum.contract.voxel.{VoxelAssets, WorldSize}
import frustum.files.InputFile
import java.nio.file.Path
import java.nio.{ByteBuffer, ByteOrder}

/** Reads MagicaVoxel's .vox (format 150 and 200, github.com/ephtracy/voxel-model): one model of up to 256 blocks a side, z up,
  * as opaque blocks of the table whose top faces come nearest to the colours of its palette. The model stands in the middle of the world's ground.
  */
object VoxFile {
  private final case class Voxel(x: Int, y: Int, z: Int, color: Int)

  def read(file: Path, size: WorldSize, assets: VoxelAssets): VoxelWorld = {
    def refuse(what: String): Nothing = throw InputError(s"$file: $what")
    val bytes = ByteBuffer.wrap(InputFile.bytes(file, "check the file")).order(ByteOrder.LITTLE_ENDIAN)
    def need(at: Int, n: Long, what: String): Unit =
      if (n < 0 || at + n > bytes.limit)
        refuse(s"byte $at: $what ends beyond the file's ${bytes.limit} bytes; save it again")
    def name(at: Int) = new String(bytes.array, at, 4, "ISO-8859-1")

    need(0, 8, "the header")
    if (name(0) != "VOX ") refuse("byte 0: is not a MagicaVoxel file; its first bytes are not 'VOX '")
    var (models, voxels, palette) = (Seq.empty[(Int, Int, Int)], Seq.empty[Voxel], defaultPalette)

    def chunks(from: Int, until: Int): Unit = {
      var at = from
      while (at < until) {
        need(at, 12, "a chunk's header")
        val (kind, content, children) = (name(at), bytes.getInt(at + 4), bytes.getInt(at + 8))
        val body = at + 12
        need(body, content, s"chunk $kind")
        need(body + content, children, s"the children of chunk $kind")
        def sized(n: Long): Unit =
          if (content < n) refuse(s"byte $at: chunk $kind has $content bytes, $n are needed; save it again")
        kind match {
          case "SIZE" =>
            sized(12)
            models :+= ((bytes.getInt(body), bytes.getInt(body + 4), bytes.getInt(body + 8)))
          case "XYZI" =>
            sized(4)
            val n = bytes.getInt(body)
            if (n < 0) refuse(s"byte $body: $n voxels; save it again")
            sized(4 + 4L * n)
            voxels = (0 until n).map { i =>
              val Seq(x, y, z, color) = (0 to 3).map(k => bytes.get(body + 4 + 4 * i + k) & 255)
              Voxel(x, y, z, color)
            }
          case "RGBA" =>
            sized(1024)
            palette = 0 +: (0 until 255).map { i =>
              (0 to 2).map(k => bytes.get(body + 4 * i + k) & 255).foldLeft(0)(_ << 8 | _)
            }
          case _ =>
        }
        if (kind == "MAIN") chunks(body + content, body + content + children)
        at = body + content + children
      }
    }
    chunks(8, bytes.limit)
    if (models.length != 1) refuse(s"has ${models.length} models; one is needed: join them in the editor")
    val (sx, sy, sz) = models.head
    if (Seq(sx, sy, sz).exists(_ < 1)) refuse(s"is a model of ${sx}x${sy}x$sz; save it again")
    if (sx > size.x || sy > size.y || sz > size.z) refuse(
      s"is a model of ${sx}x${sy}x$sz, larger than the world of $size; give a larger --world-size"
    )
    voxels.find(v => v.x >= sx || v.y >= sy || v.z >= sz).foreach(v =>
      refuse(s"voxel (${v.x}, ${v.y}, ${v.z}) lies outside its model of ${sx}x${sy}x$sz; save it again")
    )
    val nearest = palette.map(nearestBlock(assets))
    val (x0, y0) = ((size.x - sx) / 2, (size.y - sy) / 2)
    val at = voxels.map(v => (v.x + x0, v.y + y0, v.z) -> nearest(v.color)).toMap
    VoxelWorld.tabulate(size)((x, y, z) => at.getOrElse((x, y, z), 0))
  }

  private def nearestBlock(assets: VoxelAssets): Int => Int = {
    val means = assets.table.ids.map { id =>
      val top = assets.table(id).textures(5)
      val texels = for (v <- 0 until 16; u <- 0 until 16) yield assets.textures(top, u, v)
      Seq(12, 8, 4).map(at => texels.map(_ >> at & 15).sum * 17.0 / texels.length)
    }
    rgb =>
      assets.table.ids.filter(assets.table(_).opaque).minBy { id =>
        means(id - 1).zip(Seq(16, 8, 0)).map { case (mean, at) =>
          val d = mean - (rgb >> at & 255); d * d
        }.sum
      }
  }

  /** The format's palette for files without one: steps of 51 from white to black, then ramps of red, green, blue and grey. */
  private val defaultPalette: IndexedSeq[Int] = {
    val cube =
      for (r <- 255 to 0 by -51; g <- 255 to 0 by -51; b <- 255 to 0 by -51) yield r << 16 | g << 8 | b
    val ramp = Seq(0xee, 0xdd, 0xbb, 0xaa, 0x88, 0x77, 0x55, 0x44, 0x22, 0x11)
    val ramps = ramp.map(_ << 16) ++ ramp.map(_ << 8) ++ ramp ++ ramp.map(_ * 0x010101)
    (0 +: (cube.init ++ ramps)).toIndexedSeq
  }
}
