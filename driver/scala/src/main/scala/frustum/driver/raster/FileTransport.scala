package frustum.driver.raster

import java.io.{BufferedOutputStream, Closeable}
import java.nio.file.{Files, Path}

/** Writes the commands to a file, to be sent later by any program that can send bytes. Close it when done. */
final class FileTransport(file: Path) extends Transport with Closeable {
  private val out = new BufferedOutputStream(Files.newOutputStream(file))

  override def send(bytes: Seq[Int]): Unit = bytes.foreach(out.write)
  override def close(): Unit = out.close()
}
